#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
inline namespace v2 {

/// The files that a writer asks for, by their paths in its folder. They exist only in memory.
struct WrittenFiles {
  std::map<std::string, std::string> texts;
  std::map<std::string, cv::Mat> images;     ///< as they were given; masks as images
  std::map<std::string, std::string> links;  ///< to the path of a scene's file
  std::vector<std::pair<std::string, std::string>> records;  ///< channel and record, in their order
  std::vector<std::string> warnings;
};

/// Runs a writer as the core does, for tests: on hand-made scenes, without a run, a dataset folder
/// or pluginlib. Paths follow the core's rules; whether an image format can hold the pixels is
/// checked only in a run.
class TestedWriter {
 public:
  /// Initialises the writer, under the name "w", in the folder "/w/".
  /// @param writer  a new one; must outlive this object
  /// @throws Error listing everything that is wrong with the parameters, misspelt names included
  TestedWriter(LabelWriter& writer, const Value::Map& parameters, const DatasetInfo& dataset);

  /// Returns what the writer makes of a scene. It sees the scene without what it does not require.
  /// @throws Error also if the writer returns something else when called a second time: it has to
  ///     be a pure function
  WrittenFiles write(const Scene& scene);

  /// Returns the files of the dataset as a whole, for the scenes written so far. The writer can
  /// read back text files of scenes; a file at a path that the user chose is listed under that
  /// path.
  [[nodiscard]] WrittenFiles finalize() const;

  /// The warnings that the writer gave when it was initialised.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return parameters_.warnings(); }

 private:
  LabelWriter& writer_;
  WriterParameters parameters_;
  std::map<std::int64_t, WrittenFiles> scenes_;  ///< by their indices
};

}  // namespace v2
}  // namespace synthetic_dataset

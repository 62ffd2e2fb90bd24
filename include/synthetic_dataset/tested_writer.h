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

/// What a writer asks for, by paths in its folder. Nothing of it is on a disk.
struct WrittenFiles {
  std::map<std::string, std::string> texts;
  std::map<std::string, cv::Mat> images;     ///< as they were given; masks as images
  std::map<std::string, std::string> links;  ///< to the path of a scene's file
  std::vector<std::pair<std::string, std::string>> records;  ///< channel and record, in their order
  std::vector<std::string> warnings;
};

/// Runs a writer as the core does, for tests: of hand-made scenes, and without a run, a dataset's
/// folder or pluginlib. Paths follow the core's rules; that a format can hold an image's pixels is
/// what a run alone checks.
class TestedWriter {
 public:
  /// Initialises the writer, under the name "w", in the folder "/w/".
  /// @param writer  a new one; has to outlive this
  /// @throws Error with all that is wrong with the parameters, misspelt ones too
  TestedWriter(LabelWriter& writer, const Value::Map& parameters, const DatasetInfo& dataset);

  /// What a scene becomes. What the writer does not require is taken from it before.
  /// @throws Error also where the writer gives something else when it is asked a second time: it
  ///     has to be a pure function
  WrittenFiles write(const Scene& scene);

  /// The files of the dataset as a whole, of the scenes that were written so far. Texts of scenes
  /// can be read; a file at a user's path has that path.
  [[nodiscard]] WrittenFiles finalize() const;

  /// What the writer warned of when it was initialised.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return parameters_.warnings(); }

 private:
  LabelWriter& writer_;
  WriterParameters parameters_;
  std::map<std::int64_t, WrittenFiles> scenes_;  ///< by their indices
};

}  // namespace v2
}  // namespace synthetic_dataset

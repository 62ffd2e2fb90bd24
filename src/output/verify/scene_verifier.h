#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "output/file_checks.h"
#include "output/listed_dataset.h"
#include "output/verify/dataset_verifier.h"
#include "output/verify/measured_scenes.h"
#include "output/verify/true_scenes.h"
#include "plugins/readback/format.h"

namespace synthetic_dataset::output {

/// Verifies a dataset's files and labels scene by scene.
class SceneVerifier {
 public:
  /// All arguments outlive it. The counts are added to.
  SceneVerifier(const output::ListedDataset& dataset, VerificationDepth depth,
                VerificationListener& listener, VerificationCounts& counts);

  /// The files of the dataset as a whole.
  void verifyDatasetFiles();

  void verifyScene(const output::SceneFacts& scene);

  /// What the files of the dataset as a whole hold, after all scenes.
  void verifyDatasetValues();

 private:
  /// What one writer made of a scene, or of the dataset as a whole.
  struct WrittenFiles {
    std::vector<output::ListedFile> listed;
    std::vector<std::string> paths;  ///< absolute
    bool are_readable = true;
    bool are_whole = true;  ///< as they were written
  };

  /// What is known of a writer's labels.
  struct Labels {
    const formats::Format* format = nullptr;  ///< null: nothing that can be checked
    formats::Expectation expected;
    Value::Map settings;                          ///< the writer's
    std::unique_ptr<formats::ValueCheck> values;  ///< null: nobody knows what they should be
    bool is_right = true;                         ///< nothing wrong has been found yet
  };

  [[nodiscard]] Labels labelsOf(const output::StoreWriter& writer) const;
  void verifyFile(const output::ListedFile& file, WrittenFiles& of_writer);
  void verifyPictures(const output::StoreWriter& writer, const WrittenFiles& files,
                      const cv::Size& size);
  void verifyLabels(const std::string& origin, const output::SceneFacts& scene, std::size_t writer,
                    const WrittenFiles& files);
  void verifyValues(const std::string& origin, const output::SceneFacts& scene, std::size_t writer,
                    const WrittenFiles& files);
  [[nodiscard]] formats::FoundFiles foundFiles(std::size_t writer,
                                               const std::vector<std::string>& paths) const;

  const output::ListedDataset& dataset_;
  VerificationDepth depth_;
  VerificationListener& listener_;
  VerificationCounts& counts_;
  const MeasuredScenes measured_;
  const TrueScenes true_;
  std::vector<Labels> labels_;  ///< of each writer
  std::shared_ptr<formats::KeptFiles> kept_ = std::make_shared<formats::KeptFiles>();
};

}  // namespace synthetic_dataset::output

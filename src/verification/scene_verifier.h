#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "output/file_checks.h"
#include "output/listed_dataset.h"
#include "plugins/readback/drawn_label.h"
#include "synthetic_dataset/value.h"
#include "verification/dataset_verifier.h"

namespace synthetic_dataset {

/// Verifies a dataset's files and labels scene by scene.
class SceneVerifier {
 public:
  /// All arguments outlive it. The counts are added to.
  SceneVerifier(const output::ListedDataset& dataset, VerificationDepth depth,
                VerificationListener& listener, VerificationCounts& counts);

  /// The files of the dataset as a whole.
  void verifyDatasetFiles();

  void verifyScene(const output::SceneFacts& scene);

 private:
  /// Of a scene, what one writer made.
  struct WrittenFiles {
    std::vector<output::ListedFile> listed;
    std::vector<std::string> paths;  ///< absolute
    bool are_readable = true;
  };

  void verifyFile(const output::ListedFile& file, WrittenFiles& of_writer);
  void verifyPictures(const output::StoreWriter& writer, const WrittenFiles& files,
                      const cv::Size& size);
  void verifyLabels(const std::string& origin, const output::SceneFacts& scene,
                    const output::StoreWriter& writer, const WrittenFiles& files,
                    const cv::Size& size);
  [[nodiscard]] bool hasReadableLabels(const output::StoreWriter& writer) const;

  const output::ListedDataset& dataset_;
  VerificationDepth depth_;
  VerificationListener& listener_;
  VerificationCounts& counts_;
  std::map<std::string, Value> settings_;
  std::shared_ptr<readback::KeptFiles> kept_;
};

}  // namespace synthetic_dataset

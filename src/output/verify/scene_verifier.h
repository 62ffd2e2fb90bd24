#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/image/image_encoder.h"
#include "output/file_checks.h"
#include "output/verify/dataset_verifier.h"
#include "output/verify/expected_files.h"
#include "output/verify/reconstructed_scenes.h"
#include "output/verify/scene_comparison.h"
#include "output/verify/scene_pictures.h"
#include "output/writers/ready_writer.h"
#include "output/written_dataset.h"
#include "plugins/readback/format.h"

namespace synthetic_dataset::output {

/// A scene of a dataset, rendered again.
struct DrawnScene {
  const Scene& scene;
  const SceneFacts& facts;
  RecordedJpeg recorded;
  base::ImageQuality quality;
};

/// Verifies a dataset's files and labels scene by scene: each writer receives again what the run
/// gave it, reconstructed from the manifest and the pictures, and its output is compared with the
/// files.
class SceneVerifier {
 public:
  /// All arguments must outlive this. The counts are added to.
  /// @param loader  of the writers; null if labels are not to be checked
  SceneVerifier(const WrittenDataset& dataset, VerificationDepth depth, WriterLoader* loader,
                VerificationListener& listener, VerificationCounts& counts);

  /// Verifies the files of the dataset as a whole.
  void verifyDatasetFiles();

  void verifyScene(const SceneFacts& scene);

  /// Verifies the content of the files of the dataset as a whole, after all scenes.
  void verifyDatasetValues();

  /// Compares a scene's files, and what the manifest holds about it, with a new rendering.
  void verifyDrawn(const DrawnScene& drawn);

 private:
  static constexpr const char* kDrawnAgain = "drawn again, ";

  /// The files that one writer made for a scene, or for the dataset as a whole.
  struct WrittenFiles {
    std::vector<ListedFile> listed;
    std::vector<std::string> paths;  ///< absolute
    bool are_readable = true;
    bool are_whole = true;  ///< unchanged since they were written
  };

  /// What is known about a writer's labels.
  struct Labels {
    const formats::Format* format = nullptr;  ///< null if it is not one of this package's formats
    bool can_be_read = false;                 ///< by the format, from the existing files
    std::unique_ptr<ReadyWriter> writer;      ///< null if it cannot be run: nothing is compared
    bool is_right = true;                     ///< nothing wrong has been found yet
    bool has_unknown_files = false;           ///< which files cannot be verified has been reported
    std::set<std::string> known = {};         ///< problems found before scenes were rendered again
  };

  void loadWriters(WriterLoader& loader);
  void remark(const std::string& what);
  void report(std::size_t writer, const std::string& problem);
  [[nodiscard]] std::string originOf(const SceneFacts& scene, std::size_t writer) const;

  void verifyFile(const ListedFile& file, WrittenFiles& of_writer);
  [[nodiscard]] bool isSound(const SceneFacts& scene);
  bool verifyPictures(const StoreWriter& writer, const WrittenFiles& files,
                      const SceneFacts& scene);
  [[nodiscard]] formats::WrittenScene writtenScene(const SceneFacts& scene, std::size_t writer,
                                                   const WrittenFiles& files) const;

  void verifyValues(const SceneFacts& facts, const std::vector<WrittenFiles>& files,
                    const std::vector<std::size_t>& writers);
  [[nodiscard]] FoundScene foundScene(const SceneFacts& facts, std::size_t writer,
                                      const WrittenFiles& files) const;
  void takePictures(const SceneFacts& facts, const Scene& scene, std::size_t writer,
                    const WrittenFiles& files, ScenePictures& pictures, FoundScene& found);
  [[nodiscard]] bool dependsOnUnknown(std::size_t writer, const ScenePictures& pictures) const;
  void compare(const SceneFacts& facts, std::size_t writer, const WrittenFiles& files,
               const FoundScene& found, const RewrittenScene& right);
  [[nodiscard]] std::vector<std::string> wrongLabels(const SceneFacts& facts, std::size_t writer,
                                                     const WrittenFiles& files,
                                                     const SceneFiles& right) const;
  void compareDatasetFiles(std::size_t writer, const std::vector<std::string>& paths);
  bool reportWrongLabels(std::size_t writer, ExpectedFiles& right);

  const WrittenDataset& dataset_;
  VerificationDepth depth_;
  VerificationListener& listener_;
  VerificationCounts& counts_;
  const ReconstructedScenes true_;
  std::vector<Labels> labels_;       ///< one per writer
  bool has_unsound_scenes_ = false;  ///< the first one has been reported
  std::shared_ptr<formats::KeptFiles> kept_ = std::make_shared<formats::KeptFiles>();
};

}  // namespace synthetic_dataset::output

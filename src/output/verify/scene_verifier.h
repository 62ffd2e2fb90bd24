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
#include "output/verify/right_files.h"
#include "output/verify/scene_comparison.h"
#include "output/verify/scene_pictures.h"
#include "output/verify/true_scenes.h"
#include "output/writers/ready_writer.h"
#include "output/written_dataset.h"
#include "plugins/readback/format.h"

namespace synthetic_dataset::output {

/// A scene of a dataset, as it is when it is drawn again.
struct DrawnScene {
  const Scene& scene;
  const SceneFacts& facts;
  RecordedJpeg recorded;
  base::ImageQuality quality;
};

/// Verifies a dataset's files and labels scene by scene: each writer is given once more what it was
/// given by the run, as the manifest and the pictures have it, and what it makes of that is held
/// against the files.
class SceneVerifier {
 public:
  /// All arguments outlive it. The counts are added to.
  /// @param loader  of the writers; null: labels are not checked
  SceneVerifier(const WrittenDataset& dataset, VerificationDepth depth, WriterLoader* loader,
                VerificationListener& listener, VerificationCounts& counts);

  /// The files of the dataset as a whole.
  void verifyDatasetFiles();

  void verifyScene(const SceneFacts& scene);

  /// What the files of the dataset as a whole hold, after all scenes.
  void verifyDatasetValues();

  /// Compares a scene's files, and what the manifest has of it, with a new drawing.
  void verifyDrawn(const DrawnScene& drawn);

 private:
  static constexpr const char* kDrawnAgain = "drawn again, ";

  /// What one writer made of a scene, or of the dataset as a whole.
  struct WrittenFiles {
    std::vector<ListedFile> listed;
    std::vector<std::string> paths;  ///< absolute
    bool are_readable = true;
    bool are_whole = true;  ///< as they were written
  };

  /// What is known of a writer's labels.
  struct Labels {
    const formats::Format* format = nullptr;  ///< null: none of this package's
    bool can_be_read = false;                 ///< by the format, from the files that are there
    std::unique_ptr<ReadyWriter> writer;      ///< null: nobody knows what is right
    bool is_right = true;                     ///< nothing wrong has been found yet
    bool has_unknown_files = false;           ///< it is said which files nobody can know
    std::set<std::string> known = {};         ///< what is wrong, before scenes are drawn again
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
  bool reportWrongLabels(std::size_t writer, RightFiles& right);

  const WrittenDataset& dataset_;
  VerificationDepth depth_;
  VerificationListener& listener_;
  VerificationCounts& counts_;
  const TrueScenes true_;
  std::vector<Labels> labels_;       ///< of each writer
  bool has_unsound_scenes_ = false;  ///< the first one is named
  std::shared_ptr<formats::KeptFiles> kept_ = std::make_shared<formats::KeptFiles>();
};

}  // namespace synthetic_dataset::output

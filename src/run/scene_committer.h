#pragma once

#include <mutex>
#include <vector>

#include "output/background_worker.h"
#include "output/dataset_store.h"
#include "render/pending_picture.h"
#include "synthetic_dataset/scene.h"
#include "writers/writer_host.h"

namespace synthetic_dataset {

/// Finishes, formats, encodes and commits scenes, one after another, while the caller makes the
/// next ones.
///
/// A scene that fails ends with its error out of the next call; those behind it are not written.
class SceneCommitter {
 public:
  SceneCommitter(const writers::WriterHost& writers, output::DatasetStore& store);

  /// Waits while too many scenes wait already.
  /// @param image  makes the scene's
  void add(Scene scene, render::PendingPicture image, output::SceneFacts facts);

  /// Waits until all scenes are committed.
  void finish() { worker_.finish(); }

  /// The warnings of each scene that was committed since they were taken last.
  [[nodiscard]] std::vector<std::vector<output::Warning>> takeCommitted();

 private:
  void commit(const Scene& scene, output::SceneFacts& facts);

  const writers::WriterHost& writers_;
  output::DatasetStore& store_;
  std::mutex mutex_;
  std::vector<std::vector<output::Warning>> committed_;
  output::BackgroundWorker worker_;  ///< last: its jobs use all of the above
};

}  // namespace synthetic_dataset

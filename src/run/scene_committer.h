#pragma once

#include <mutex>
#include <vector>

#include "output/background_worker.h"
#include "output/dataset_store.h"
#include "run/pending_scene.h"
#include "writers/writer_host.h"

namespace synthetic_dataset {

/// Finishes, formats, encodes and commits scenes in their order, while the caller makes the next
/// ones: one thread finishes a scene while another one writes the one before.
///
/// A scene that fails ends with its error out of one of the next calls; those behind it are not
/// written.
class SceneCommitter {
 public:
  SceneCommitter(const writers::WriterHost& writers, output::DatasetStore& store);

  /// Waits while too many scenes wait already.
  void add(PendingScene scene);

  /// Waits until all scenes are committed.
  void finish();

  /// The warnings of each scene that was committed since they were taken last.
  [[nodiscard]] std::vector<std::vector<output::Warning>> takeCommitted();

 private:
  void commit(FinishedScene& finished);

  const writers::WriterHost& writers_;
  output::DatasetStore& store_;
  std::mutex mutex_;
  std::vector<std::vector<output::Warning>> committed_;
  output::BackgroundWorker writer_;
  output::BackgroundWorker finisher_;  ///< last: its jobs use all of the above
};

}  // namespace synthetic_dataset

#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "base/background_worker.h"
#include "run/reporter.h"
#include "run/scene_sink.h"
#include "run/stage_times.h"

namespace synthetic_dataset::run {

/// Finishes a scene from what was drawn for it, once, in any thread, as long as what drew it lives.
using PendingScene = std::function<FinishedScene()>;

/// Finishes scenes and adds them to a sink, in their order, while the caller makes the next ones:
/// one thread finishes a scene while another one has the sink take the one before. At most one
/// scene waits for each. Progress and warnings are reported in the caller's thread.
///
/// A scene that fails ends with its error out of one of the next calls; those behind it are not
/// added.
class ScenePipeline {
 public:
  /// @param sink, reporter  have to outlive this
  /// @param scene_count  how many scenes will come
  ScenePipeline(SceneSink& sink, Reporter& reporter, std::int64_t scene_count);

  /// Waits while too many scenes wait already. Of a large image, what was drawn takes much memory:
  /// such a scene is finished before this returns.
  /// @param pixel_count  of the scene's image
  void add(PendingScene scene, std::int64_t pixel_count);

  /// Waits until the sink has all scenes.
  void finish();

  /// How many scenes the sink has taken, as far as it was reported.
  [[nodiscard]] std::int64_t addedCount() const { return added_count_; }

  /// How long scenes were finished and added, after finish().
  [[nodiscard]] StageTimes times() const { return times_; }

  /// How long the caller has waited in add() and finish() [s].
  [[nodiscard]] double waited() const { return waited_; }

 private:
  [[nodiscard]] FinishedScene finishScene(const PendingScene& scene);
  void addToSink(const FinishedScene& finished);
  void report();

  SceneSink& sink_;
  Reporter& reporter_;
  std::int64_t scene_count_;
  std::int64_t added_count_ = 0;
  double waited_ = 0.0;
  std::mutex mutex_;
  std::vector<std::vector<base::Warning>> unreported_;  ///< of each scene that was added
  StageTimes times_;
  base::BackgroundWorker adder_;
  base::BackgroundWorker finisher_;  ///< last: its jobs use all of the above
};

}  // namespace synthetic_dataset::run

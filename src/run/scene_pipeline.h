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

/// Finishes a scene from what was drawn for it. Call it once, in any thread, while the object that
/// drew the scene exists.
using PendingScene = std::function<FinishedScene()>;

/// Finishes scenes and adds them to a sink, in order, while the caller makes the next ones: one
/// thread finishes a scene while another adds the previous scene to the sink. At most one scene
/// waits for each thread. Progress and warnings are reported in the caller's thread.
///
/// If a scene fails, one of the next calls throws its error; later scenes are not added.
class ScenePipeline {
 public:
  /// @param sink, reporter  must outlive this
  /// @param scene_count  how many scenes will come
  ScenePipeline(SceneSink& sink, Reporter& reporter, std::int64_t scene_count);

  /// Blocks while too many scenes are waiting. Because the drawing data of a large image takes much
  /// memory, such a scene is finished before this returns.
  /// @param pixel_count  of the scene's image
  void add(PendingScene scene, std::int64_t pixel_count);

  /// Blocks until the sink has all scenes.
  void finish();

  /// How many scenes the sink has taken, as far as this has been reported.
  [[nodiscard]] std::int64_t addedCount() const { return added_count_; }

  /// The time spent finishing and adding scenes; call after finish().
  [[nodiscard]] StageTimes times() const { return times_; }

  /// How long the caller was blocked in add() and finish() [s].
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
  std::vector<std::vector<base::Warning>> unreported_;  ///< for each added scene
  StageTimes times_;
  base::BackgroundWorker adder_;
  base::BackgroundWorker finisher_;  ///< last, since its jobs use all of the above
};

}  // namespace synthetic_dataset::run

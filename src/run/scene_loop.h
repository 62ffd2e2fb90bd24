#pragma once

#include <cstdint>
#include <memory>

#include "run/motion_run.h"
#include "run/reporter.h"
#include "run/scene_sink.h"
#include "run/setup/run_setup.h"
#include "run/stage_times.h"
#include "run/work_plan.h"

namespace synthetic_dataset::run {

/// The loop over a run's motions: makes the scenes that a sink wants.
///
/// OpenGL belongs to the thread that makes the loop; use it from there.
class SceneLoop {
 public:
  /// Prepares drawing and then calls the sink's `begin`.
  /// @param setup, sink, reporter  must outlive this; the OpenGL version is added to the setup's
  ///     description before the sink begins
  /// @throws Error if drawing is not possible; whatever the sink throws
  SceneLoop(RunSetup& setup, SceneSink& sink, Reporter& reporter);

  /// How many scenes are to be made.
  [[nodiscard]] std::int64_t sceneCount() const { return work_.sceneCount(); }

  struct Result {
    std::int64_t scenes = 0;  ///< taken by the sink
    RunEnd end = RunEnd::kAllMade;
    StageTimes times;
  };

  /// Makes all scenes and then calls the sink's `finish`.
  /// @throws Error if a scene cannot be made or the sink fails
  Result run();

 private:
  [[nodiscard]] std::unique_ptr<MotionRun> makeRun(MotionSetup& motion) const;
  [[nodiscard]] WorkPlan begin();
  [[nodiscard]] RunEnd makeScenes(ScenePipeline& pipeline);

  RunSetup& setup_;
  SceneSink& sink_;
  Reporter& reporter_;
  std::unique_ptr<MotionRun> motion_run_;  ///< of the current motion, initially the first
  WorkPlan work_;
};

}  // namespace synthetic_dataset::run

#include "run/scene_loop.h"

#include "run/scene_pipeline.h"
#include "run/setup/dataset_description.h"

namespace synthetic_dataset::run {

SceneLoop::SceneLoop(RunSetup& setup, SceneSink& sink, Reporter& reporter)
    : setup_(setup),
      sink_(sink),
      reporter_(reporter),
      motion_run_(makeRun(setup.motions.front())),
      work_(begin()) {}

std::unique_ptr<MotionRun> SceneLoop::makeRun(MotionSetup& motion) const {
  reporter_.stage("giving the world to OpenGL");
  return std::make_unique<MotionRun>(motion, *setup_.splits, sink_.requirements());
}

WorkPlan SceneLoop::begin() {
  setup_.description.software["opengl"] = motion_run_->glVersion();
  reporter_.stage("opening the output folder");
  const DatasetInfo dataset = describeDataset(setup_.config, setup_.motions, *setup_.splits);
  sink_.begin(dataset);
  return {setup_.instantCount(), static_cast<std::int64_t>(dataset.cameras.size()),
          [this](std::int64_t scene) { return sink_.wants(scene); }};
}

SceneLoop::Result SceneLoop::run() {
  ScenePipeline pipeline(sink_, reporter_, work_.sceneCount());
  const StageWatch of_scenes;
  const RunEnd end = makeScenes(pipeline);
  StageTimes times = pipeline.times();
  times.drawing = of_scenes.seconds() - pipeline.waited();
  const StageWatch of_files;
  sink_.finish(end);
  times.dataset_files = of_files.seconds();
  return {pipeline.addedCount(), end, times};
}

RunEnd SceneLoop::makeScenes(ScenePipeline& pipeline) {
  for (MotionSetup& motion : setup_.motions) {
    const std::int64_t end = motion.first_instant + motion.instantCount();
    if (work_.endOfWork(end) <= motion.first_instant) continue;
    if (!motion_run_->isOf(motion)) {
      motion_run_.reset();  // two cannot draw at once
      motion_run_ = makeRun(motion);
    }
    const bool goes_on = motion_run_->run(work_, pipeline, reporter_);
    pipeline.finish();  // finishing scenes needs the motion run's renderer
    if (!goes_on) return RunEnd::kStopped;
  }
  // The sink's `finish` may take long, too.
  return reporter_.stopRequested() ? RunEnd::kStopped : RunEnd::kAllMade;
}

}  // namespace synthetic_dataset::run

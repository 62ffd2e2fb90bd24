#include "run/live/glance.h"

#include <algorithm>
#include <utility>

#include "run/live/one_scene_sink.h"
#include "run/reporter.h"
#include "run/scene_pipeline.h"
#include "run/work_plan.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

constexpr int kShrunk = 2;  // per side

/// The same view with fewer pixels, whose centres have integer coordinates.
CameraModel coarse(const CameraModel& camera) {
  const int width = std::max(1, camera.width() / kShrunk);
  const int height = std::max(1, camera.height() / kShrunk);
  const double across = static_cast<double>(width) / camera.width();
  const double down = static_cast<double>(height) / camera.height();
  const Intrinsics& lens = camera.intrinsics();
  return {width,
          height,
          {lens.fx * across, lens.fy * down, (lens.cx + 0.5) * across - 0.5,
           (lens.cy + 0.5) * down - 0.5},
          camera.near(),
          camera.far(),
          camera.distortion()};
}

/// Puts the camera at a pose, overriding what it would follow or look at.
void putAt(const Pose& X_GC, scene::CameraRig& rig) {
  rig.X_GC = X_GC;
  rig.looks_at.reset();
  rig.X_FD.reset();
  rig.optical_frame = rig.frame;
}

}  // namespace

Glance::Glance(RunSetup run) : run_(std::move(run)) {
  for (MotionSetup& motion : run_.motions) {
    motion.config.rendering.samples = 1;
    for (scene::CameraRig& rig : motion.cameras) {
      rig.model = coarse(rig.model);
      rig.shutter = {};
    }
  }
}

bool Glance::canGoOn() const {
  return std::all_of(run_.motions.begin(), run_.motions.end(), [](const MotionSetup& motion) {
    return motion.history || motion.arranger->standsAlone();
  });
}

cv::Mat Glance::picture(std::int64_t instant, std::size_t camera, const Pose& X_GC) {
  MotionSetup& motion = motionOf(instant);
  if (motion.config.hasRecordedImages()) throw Error("the run's pictures are recorded ones");
  if (!drawing_ || !drawing_->isOf(motion)) {
    drawing_.reset();  // two cannot draw at once
    drawing_ = std::make_unique<MotionRun>(motion, *run_.splits, Requirements());
  }
  putAt(X_GC, motion.cameras.at(camera));
  const auto camera_count = static_cast<std::int64_t>(motion.cameras.size());
  const std::int64_t index = instant * camera_count + static_cast<std::int64_t>(camera);
  const WorkPlan work(run_.instantCount(), camera_count,
                      [&](std::int64_t scene) { return scene == index; });
  OneSceneSink sink(index, {});
  Reporter silent;
  ScenePipeline pipeline(sink, silent, 1);
  (void)drawing_->run(work, pipeline, silent);
  pipeline.finish();
  return sink.scene().value().image;
}

MotionSetup& Glance::motionOf(std::int64_t instant) {
  for (MotionSetup& motion : run_.motions) {
    const std::int64_t end = motion.first_instant + motion.instantCount();
    if (motion.first_instant <= instant && instant < end) return motion;
  }
  throw Error("found instant " + std::to_string(instant) + "; the run has 0 to " +
              std::to_string(run_.instantCount() - 1));
}

}  // namespace synthetic_dataset::run

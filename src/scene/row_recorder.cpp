#include "scene/row_recorder.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace synthetic_dataset::scene {

RowRecorder::RowRecorder(const world::World& world, const std::vector<CameraRig>& cameras,
                         bool follows_rows)
    : world_(world), cameras_(cameras), taken_(cameras.size()) {
  for (const CameraRig& camera : cameras_) {
    Shutter sharp = camera.shutter;
    sharp.exposure_time = Duration{0};
    Shot shot = shotsOf(sharp, camera.model.height()).front();
    if (!follows_rows || !shot.rolls()) shot.moments.clear();
    for (const ShotMoment& moment : shot.moments) offsets_.push_back(moment.offset);
    shots_.push_back(std::move(shot));
  }
  std::sort(offsets_.begin(), offsets_.end());
  offsets_.erase(std::unique(offsets_.begin(), offsets_.end()), offsets_.end());
}

void RowRecorder::record(std::size_t camera, Duration offset, CameraPoses& poses,
                         const std::vector<std::optional<Pose>>& X_GO) {
  for (const ShotMoment& moment : shots_[camera].moments) {
    if (moment.offset != offset) continue;
    std::optional<label::CapturedRows>& taken = taken_[camera];
    const render::LinkSelection& present = world_.presentLinks();
    if (!taken) {
      const int bands = static_cast<int>(shots_[camera].moments.size()) - 1;
      taken = label::CapturedRows{{cameras_[camera].model, {}, bands}, present, {}};
    }
    std::transform(present.begin(), present.end(), taken->present.begin(), taken->present.begin(),
                   std::logical_and<>());
    taken->view.moments.push_back({moment.row, poses.of(camera).X_GC, world_.linkPoses()});
    taken->X_GO.push_back(X_GO);
  }
}

label::CapturedRows RowRecorder::take(std::size_t camera) {
  return std::exchange(taken_[camera], std::nullopt).value();
}

}  // namespace synthetic_dataset::scene

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "label/row_labels.h"
#include "scene/camera_poses.h"
#include "scene/camera_rig.h"
#include "scene/shutter.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// Records where everything is while rolling shutters take their rows, for labels of each row's own
/// time: the middle of its exposure.
///
/// For each instant: move the world to each of `offsets` from the instant and `record`, then `take`
/// each camera's.
class RowRecorder {
 public:
  /// All references have to outlive this.
  /// @param follows_rows  whether labels are of the rows' times; if not, nothing is recorded
  RowRecorder(const world::World& world, const std::vector<CameraRig>& cameras, bool follows_rows);

  /// The offsets from an instant at which something is recorded, ascending.
  [[nodiscard]] const std::vector<Duration>& offsets() const { return offsets_; }

  /// Whether something is recorded for a camera.
  [[nodiscard]] bool follows(std::size_t camera) const { return shots_[camera].rolls(); }

  /// Whether something is recorded for any camera.
  [[nodiscard]] bool followsAny() const { return !offsets_.empty(); }

  /// Records the world as it stands at `offset` from the instant, if the camera needs that.
  /// @param poses  of the cameras at that time
  /// @param X_GO  of the objects at that time
  void record(std::size_t camera, Duration offset, CameraPoses& poses,
              const std::vector<std::optional<Pose>>& X_GO);

  /// What was recorded for a camera for which follows() is true; to be called after the last of its
  /// times.
  [[nodiscard]] label::CapturedRows take(std::size_t camera);

 private:
  const world::World& world_;
  const std::vector<CameraRig>& cameras_;
  std::vector<Shot> shots_;  ///< of cameras_; without moments if nothing is recorded
  std::vector<std::optional<label::CapturedRows>> taken_;
  std::vector<Duration> offsets_;
};

}  // namespace synthetic_dataset::scene

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/frame_source.h"
#include "scene/camera_rig.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

struct CameraPose {
  Pose X_GF;  ///< of the camera's `frame`
  Pose X_GC;  ///< of the picture's optical frame
};

/// The pose of a camera at `offset` from `instant`, while the world stands at that time. If a
/// frame's pose is not known then, its pose at the instant is used.
[[nodiscard]] CameraPose cameraPose(const CameraRig& camera, const world::World& world,
                                    const motion::FrameSource& frames, Stamp instant,
                                    Duration offset = Duration{0});

/// The poses of all cameras at one time, while the world stands at it. Each is computed when it is
/// first asked for.
class CameraPoses {
 public:
  /// All references have to outlive this.
  CameraPoses(const std::vector<CameraRig>& cameras, const world::World& world,
              const motion::FrameSource& frames, Stamp instant, Duration offset = Duration{0});

  [[nodiscard]] const CameraPose& of(std::size_t camera);

 private:
  const std::vector<CameraRig>& cameras_;
  const world::World& world_;
  const motion::FrameSource& frames_;
  Stamp instant_;
  Duration offset_;
  std::vector<std::optional<CameraPose>> poses_;
};

}  // namespace synthetic_dataset::scene

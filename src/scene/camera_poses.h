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

/// Where a camera is at a time around `instant`, at which the world stands. A frame whose pose is
/// not known then has that of the instant.
[[nodiscard]] CameraPose cameraPose(const CameraRig& camera, const world::World& world,
                                    const motion::FrameSource& frames, Stamp instant,
                                    Duration offset = Duration{0});

/// Where all cameras are at one time, while the world stands there. Each is found when it is first
/// asked for.
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

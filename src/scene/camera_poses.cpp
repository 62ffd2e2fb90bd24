#include "scene/camera_poses.h"

#include "base/seconds.h"
#include "randomize/placement/camera_sampler.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {
namespace {

/// X_GF at `offset` from `instant`; if it is not known then, that of the instant.
Pose poseAround(motion::FrameId frame, const motion::FrameSource& frames, Stamp instant,
                Duration offset) {
  const auto X_GF_then = frames.pose(frame, instant + offset);
  return X_GF_then ? *X_GF_then : frames.knownPose(frame, instant);
}

/// The centre of the object's active variant.
Eigen::Vector3d middleOf(const FollowedObject& object, const world::World& world,
                         const Pose& X_GO) {
  if (object.centres_O.empty()) return X_GO.translation();
  return X_GO * object.centres_O[world.variant(object.object)];
}

/// X_GF according to the sources, without the correction X_FD.
Pose sourcePose(const CameraRig& camera, const world::World& world,
                const motion::FrameSource& frames, Stamp instant, Duration offset) {
  if (camera.X_GC) return *camera.X_GC;
  if (camera.link) return world.linkPoses()[*camera.link] * camera.X_LC;
  Pose X_GF = camera.followed == motion::kNoFrame
                  ? Pose::Identity()
                  : poseAround(camera.followed, frames, instant, offset);
  if (camera.is_carried || camera.looks_at) X_GF = X_GF * camera.X_LC;
  if (!camera.looks_at) return X_GF;
  const Eigen::Vector3d position_G = X_GF.translation();
  const Eigen::Vector3d target_G = middleOf(
      *camera.looks_at, world, poseAround(camera.looks_at->frame, frames, instant, offset));
  constexpr double kNoDirection = 1e-9;  // [m]
  if ((target_G - position_G).norm() > kNoDirection) {
    return randomize::lookingAt(position_G, target_G, 0.0);
  }
  throw Error("camera " + camera.name + ": at " + fixed(toSeconds(instant + offset), 3) +
              " s it is in the middle of what it looks at (pose/look_at)");
}

}  // namespace

CameraPose cameraPose(const CameraRig& camera, const world::World& world,
                      const motion::FrameSource& frames, Stamp instant, Duration offset) {
  Pose X_GF = sourcePose(camera, world, frames, instant, offset);
  if (camera.X_FD) X_GF = X_GF * *camera.X_FD;
  return {X_GF, camera.optical_frame == camera.frame ? X_GF : Pose(X_GF * camera.X_FC)};
}

CameraPoses::CameraPoses(const std::vector<CameraRig>& cameras, const world::World& world,
                         const motion::FrameSource& frames, Stamp instant, Duration offset)
    : cameras_(cameras),
      world_(world),
      frames_(frames),
      instant_(instant),
      offset_(offset),
      poses_(cameras.size()) {}

const CameraPose& CameraPoses::of(std::size_t camera) {
  std::optional<CameraPose>& pose = poses_[camera];
  if (!pose) pose = cameraPose(cameras_[camera], world_, frames_, instant_, offset_);
  return *pose;
}

}  // namespace synthetic_dataset::scene

#include "scene/stereo_pairs.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {
namespace {

/// Whether both cameras are in the same frame, by its name or by its pose.
bool shareFrame(const CameraRig& a, const CameraRig& b) {
  return a.frame == b.frame || (a.X_GC && b.X_GC && a.X_GC->isApprox(*b.X_GC, 0.0));
}

bool isBesideItsFrame(const CameraRig& camera) {
  return camera.is_rectified && !camera.X_FC.translation().isZero(0.0);
}

/// From the first camera's rectified position to the second one's [m], in the first one's frame.
Eigen::Vector3d baselineOf(const CameraRig& first, const CameraRig& second) {
  return first.X_FC.linear() * (second.X_FC.linear().transpose() * second.X_FC.translation());
}

/// X_FS, the pose of the second camera's frame in the first one's, at a time at which both are
/// known.
std::optional<Pose> between(const CameraRig& first, const CameraRig& second,
                            const motion::FrameSource& frames) {
  if (first.X_GC && second.X_GC) return Pose(first.X_GC->inverse() * *second.X_GC);
  if (!first.followsFrame() || !second.followsFrame()) return std::nullopt;
  try {
    motion::TimelineOptions options;
    options.period = std::chrono::milliseconds(100);
    options.scenes = 1;
    const motion::Timeline known = frames.timeline({first.frame, second.frame}, options);
    if (known.stamps.empty()) return std::nullopt;
    const Stamp time = known.stamps.front();
    return Pose(frames.knownPose(first.followed, time).inverse() *
                frames.knownPose(second.followed, time));
  } catch (const Error&) {  // they are never known at the same time
    return std::nullopt;
  }
}

void takeOwnFrame(CameraRig& second) {
  second.X_FC.translation().setZero();
  if (second.X_FC.isApprox(Pose::Identity(), 0.0)) second.optical_frame = second.frame;
}

void alignWith(const CameraRig& first, CameraRig& second) {
  const Eigen::Vector3d p_FC = first.X_FC.translation() + baselineOf(first, second);
  second.X_FC = first.X_FC;
  second.X_FC.translation() = p_FC;
}

class PairPlacer {
 public:
  PairPlacer(std::vector<CameraRig>& cameras, const motion::FrameSource& frames,
             base::Diagnostics& diagnostics)
      : cameras_(cameras), frames_(frames), diagnostics_(diagnostics) {}

  void place(CameraRig& second) {
    if (second.stereo_frame == StereoFrame::kOwn) {
      takeOwnFrame(second);
      return;
    }
    const CameraRig* first =
        firstWith([&](const CameraRig& other) { return shareFrame(other, second); });
    if (first != nullptr) {
      alignWith(*first, second);
      return;
    }
    if (second.stereo_frame == StereoFrame::kFirst) return;
    const bool is_own =
        firstWith([&](const CameraRig& other) { return isBaselineAway(other, second); }) != nullptr;
    if (is_own) {
      takeOwnFrame(second);
    } else if (second.followsFrame()) {
      diagnostics_.warning(
          "camera " + second.name,
          "its calibration is that of a stereo pair's second camera, " +
              fixed(second.X_FC.translation().norm(), 4) +
              " m beside the first, and is taken to be in the first one's frame, as in "
              "ROS: " +
              second.frame +
              " (if this is its own frame, `stereo_frame: own` says so; `first` "
              "confirms it)");
    }
  }

 private:
  /// The first camera of a pair for which a condition holds.
  template <class Condition>
  const CameraRig* firstWith(const Condition& holds) const {
    const auto first = std::find_if(cameras_.begin(), cameras_.end(), [&](const CameraRig& other) {
      return other.is_rectified && !isBesideItsFrame(other) && holds(other);
    });
    return first == cameras_.end() ? nullptr : &*first;
  }

  /// Whether the frames are a baseline apart rather than at the same place, within the accuracy of
  /// frames measured by hand.
  [[nodiscard]] bool isBaselineAway(const CameraRig& first, const CameraRig& second) const {
    const auto X_FS = between(first, second, frames_);
    const Eigen::Vector3d baseline = baselineOf(first, second);
    return X_FS && (X_FS->translation() - baseline).norm() < 0.5 * baseline.norm();
  }

  std::vector<CameraRig>& cameras_;
  const motion::FrameSource& frames_;
  base::Diagnostics& diagnostics_;
};

}  // namespace

void placeStereoPairs(std::vector<CameraRig>& cameras, const motion::FrameSource& frames,
                      base::Diagnostics& diagnostics) {
  PairPlacer placer(cameras, frames, diagnostics);
  for (CameraRig& second : cameras) {
    if (isBesideItsFrame(second)) placer.place(second);
  }
}

void notePictureFrames(const std::vector<CameraRig>& cameras, base::Diagnostics& diagnostics) {
  for (const CameraRig& camera : cameras) {
    if (camera.optical_frame == camera.frame) continue;
    const Eigen::Vector3d p = camera.X_FC.translation() + Eigen::Vector3d::Zero();  // no -0
    const double angle = Eigen::AngleAxisd(camera.X_FC.linear()).angle();
    diagnostics.note("camera " + camera.name, "its calibration puts the picture's frame, " +
                                                  camera.optical_frame + ", at [" +
                                                  fixed(p.x(), 4) + ", " + fixed(p.y(), 4) + ", " +
                                                  fixed(p.z(), 4) + "] m in " + camera.frame +
                                                  ", turned by " + fixed(angle, 4) + " rad");
  }
}

}  // namespace synthetic_dataset::scene

#pragma once

#include <initializer_list>
#include <string>

#include "synthetic_dataset/label_writer.h"

/// What KITTI's benchmarks of objects and of tracking share.
namespace synthetic_dataset {

inline constexpr int kKittiDecimals = 6;

namespace kitti {

/// Numbers with a space before each.
[[nodiscard]] std::string columns(std::initializer_list<double> numbers);

/// Left, top, right, bottom. Pixels count from the image's edge here, not from the first pixel's
/// centre.
[[nodiscard]] std::string boxColumns(const Box& box);

/// 0 fully visible, 1 partly occluded, 2 largely occluded: of the part in the image.
[[nodiscard]] int occlusionOf(const PixelCounts& pixels);

/// Whether the object's z axis differs so much from the camera's upward one that a turn about the
/// camera's y axis alone does not say how it stands.
[[nodiscard]] bool isTilted(const Pose& X_CO);

/// The columns from height on, and the observation angle that stands before the 2D box. Length lies
/// along the object's x axis, width along y, height along z.
struct Placement {
  double alpha = 0.0;
  std::string columns;
};

[[nodiscard]] Placement placementOf(const SceneObject& object);

/// A file of `calib`.
[[nodiscard]] std::string calibration(const Intrinsics& k);

/// The warning of objects that are tilted.
inline constexpr const char* kTiltWarning =
    "an object is tilted against the camera by more than 1 degree: KITTI's labels have its "
    "rotation about the camera's y axis alone";

}  // namespace kitti
}  // namespace synthetic_dataset

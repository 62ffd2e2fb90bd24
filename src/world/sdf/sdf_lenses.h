#pragma once

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

struct Lens {
  Intrinsics intrinsics;
  Distortion distortion;
};

/// A camera's `<image>` and `<horizontal_fov>`.
struct CameraImage {
  int width = 320;               ///< [px]
  int height = 240;              ///< [px]
  double field_of_view = 1.047;  ///< [rad]
};

/// A lens that SDF can describe and CameraModel cannot.
class UnsupportedLens : public Error {
 public:
  using Error::Error;
};

/// A camera's <distortion>: Brown's model as Gazebo applies it, which is OpenCV's plumb_bob on
/// coordinates divided by the focal length. Gazebo then may cut the dark border off a picture with
/// a negative k1, by stretching it; this is left out, so that pictures agree with the camera's
/// calibration.
/// @throws UnsupportedLens where the distortion's centre is not the image's
[[nodiscard]] Distortion brownDistortion(const Element& camera, const SourceLocation& location,
                                         SdfReading& reading);

/// The lens of a <sensor type="wideanglecamera">: r = c1 f fun(theta / c2 + c3), r being 1 at half
/// the image's width. Lenses other than gnomonical and equidistant ones become an equidistant one
/// with coefficients that are fitted to within 0.05 px over all that the image shows.
/// @throws UnsupportedLens where no fit is that good, or r is not 0 on the axis
[[nodiscard]] Lens wideAngleLens(const CameraImage& image, const Element& camera,
                                 const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world

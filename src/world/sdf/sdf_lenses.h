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
/// coordinates divided by the focal length. With a negative k1, Gazebo may then stretch the picture
/// to crop its dark border; this is left out, so that pictures agree with the camera's calibration.
/// @throws UnsupportedLens if the centre of distortion is not that of the image
[[nodiscard]] Distortion brownDistortion(const Element& camera, const SourceLocation& location,
                                         SdfReading& reading);

/// The lens of a <sensor type="wideanglecamera">: r = c1 f fun(theta / c2 + c3), where r is 1 at
/// half the image's width. Lenses other than gnomonical and equidistant ones are approximated by an
/// equidistant one, whose coefficients are fitted to within 0.05 px over the whole image.
/// @throws UnsupportedLens if no fit is that good, or if r is not 0 on the axis
[[nodiscard]] Lens wideAngleLens(const CameraImage& image, const Element& camera,
                                 const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world

#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/random/distribution.h"
#include "scene/camera_rig.h"
#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::scene {

/// How wide a camera sees [rad]: the horizontal angle of an image in whose middle the lens's axis
/// is, of the lens without the polynomials that bend its picture. 2 atan(width / (2 fx)), in (0,
/// pi); of an equidistant lens width / fx.
[[nodiscard]] double fieldOfView(const CameraModel& camera);

/// Whether a lens of the camera's kind can see so wide [rad].
[[nodiscard]] bool canHaveFieldOfView(const CameraModel& camera, double field_of_view);

/// The same camera with another field of view [rad]: both focal lengths are scaled alike, all else
/// stays.
/// @throws Error where it cannot have it
[[nodiscard]] CameraModel withFieldOfView(const CameraModel& camera, double field_of_view);

/// Checks that each camera can have what may be drawn.
/// @throws ErrorList naming `parameter`, the cameras that cannot, and what they can have
void checkFieldOfView(const base::Distribution& field_of_view, const std::string& parameter,
                      const std::vector<CameraRig>& cameras);

/// Warns of cameras whose lenses would see next to nothing in most of the image at the widest that
/// may be drawn.
void warnOfBlackEdges(const base::Distribution& field_of_view, const std::string& parameter,
                      const std::vector<CameraRig>& cameras, base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene

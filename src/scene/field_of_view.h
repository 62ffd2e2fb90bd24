#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/random/distribution.h"
#include "scene/camera_rig.h"
#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::scene {

/// A camera's horizontal field of view [rad], as if the optical axis were in the middle of the
/// image, and without the lens's distortion polynomials: 2 atan(width / (2 fx)), in (0, pi); for an
/// equidistant lens, width / fx.
[[nodiscard]] double fieldOfView(const CameraModel& camera);

/// Whether a lens of the camera's kind can have this field of view [rad].
[[nodiscard]] bool canHaveFieldOfView(const CameraModel& camera, double field_of_view);

/// The same camera with another field of view [rad]: both focal lengths are scaled by the same
/// factor, everything else stays.
/// @throws Error if it cannot have it
[[nodiscard]] CameraModel withFieldOfView(const CameraModel& camera, double field_of_view);

/// Checks that each camera can have every field of view that may be drawn.
/// @throws ErrorList naming `parameter`, the cameras that cannot, and the widest that they can have
void checkFieldOfView(const base::Distribution& field_of_view, const std::string& parameter,
                      const std::vector<CameraRig>& cameras);

/// Warns of cameras whose lenses would see nothing in most of the image at the widest field of view
/// that may be drawn.
void warnOfBlackEdges(const base::Distribution& field_of_view, const std::string& parameter,
                      const std::vector<CameraRig>& cameras, base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene

#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "base/random/distribution.h"

namespace synthetic_dataset::randomize {

/// How a camera is put somewhere at random, anew for each scene.
struct CameraSampling {
  /// What it looks at: an object's name, `any` (one of the objects, drawn for each scene) or `all`
  /// (the middle of all). Not used where there is a point.
  std::string look_at = "any";
  std::optional<Eigen::Vector3d> look_at_point_G;

  /// Past what it looks at, along the global frame's axes [m].
  base::Distribution aim_offset = base::Distribution::constant({0, 0, 0});

  /// Where it is, seen from what it looks at, on a shell around it; or
  base::Distribution distance = base::Distribution::uniform({1.0}, {3.0});   ///< [m]
  base::Distribution elevation = base::Distribution::uniform({0.2}, {1.0});  ///< [rad]
  base::Distribution azimuth =
      base::Distribution::uniform({-3.141592653589793}, {3.141592653589793});  ///< [rad]

  /// in a box of the global frame [m].
  std::optional<base::Distribution> position_G;

  base::Distribution roll = base::Distribution::constant({0.0});  ///< [rad]
  double clearance = 0.1;                                         ///< from all that is there [m]
  int tries = 1000;
};

}  // namespace synthetic_dataset::randomize

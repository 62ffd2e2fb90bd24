#pragma once

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

/// A floor with walls around it, for objects that are placed where there is no world.
struct RoomOptions {
  Eigen::Vector3d size{8.0, 8.0, 3.0};  ///< whole lengths along x, y, z of the global frame [m]; a
                                        ///< height of 0: no walls, but open ground
  double tile = 2.0;                    ///< how much of a surface a texture covers, each way [m]
};

}  // namespace synthetic_dataset::randomize

#pragma once

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

/// A floor with walls around it, for placing objects without a world.
struct RoomOptions {
  Eigen::Vector3d size{8.0, 8.0, 3.0};  ///< full lengths along x, y, z of the global frame [m]; a
                                        ///< height of 0 means open ground without walls
  double tile = 2.0;                    ///< how much of a surface a texture covers in each
                                        ///< direction [m]
};

}  // namespace synthetic_dataset::randomize

#pragma once

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A floor with walls around it, for objects that are placed where there is no world.
struct RoomOptions {
  Eigen::Vector3d size{8.0, 8.0, 3.0};  ///< whole lengths along x, y, z of the global frame [m]; a
                                        ///< height of 0: no walls, but open ground
  double tile = 2.0;                    ///< how much of a surface a texture covers, each way [m]
};

/// What a run calls its room, also among the targets of `randomize/materials`.
inline const char* const kRoomName = "room";

/// The room's model: its floor's middle is the origin, its floor faces up. The walls are seen from
/// both sides. Visuals: "floor" and, with walls, "wall_1" to "wall_4".
[[nodiscard]] world::Model makeRoom(const RoomOptions& options);

}  // namespace synthetic_dataset::randomize

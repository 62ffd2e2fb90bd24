#pragma once

#include "randomize/appearance/room_options.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// The name of a run's room, also as a target of `randomize/materials`.
inline const char* const kRoomName = "room";

/// The room's model. Its origin is the middle of its floor, which faces up. The walls are visible
/// from both sides. Visuals: "floor" and, with walls, "wall_1" to "wall_4".
[[nodiscard]] world::Model makeRoom(const RoomOptions& options);

}  // namespace synthetic_dataset::randomize

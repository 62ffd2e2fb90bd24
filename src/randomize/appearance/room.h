#pragma once

#include "randomize/appearance/room_options.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// What a run calls its room, also among the targets of `randomize/materials`.
inline const char* const kRoomName = "room";

/// The room's model: its floor's middle is the origin, its floor faces up. The walls are seen from
/// both sides. Visuals: "floor" and, with walls, "wall_1" to "wall_4".
[[nodiscard]] world::Model makeRoom(const RoomOptions& options);

}  // namespace synthetic_dataset::randomize

#include <algorithm>
#include <vector>

#include "config/checked_values.h"
#include "config/readers.h"

namespace synthetic_dataset::config {

std::optional<randomize::RoomOptions> readRoom(Parameters randomize) {
  if (!randomize.has("room")) return std::nullopt;
  constexpr double kSmallest = 1e-2;  // [m]
  constexpr double kLargest = 1e4;    // [m]
  Parameters group = randomize.group("room");
  randomize::RoomOptions room;
  if (group.has("size")) {
    const auto size = group.required<std::vector<double>>("size");
    const bool is_room = size.size() == 3 && std::min(size[0], size[1]) >= kSmallest &&
                         size[2] >= 0.0 && *std::max_element(size.begin(), size.end()) <= kLargest;
    if (is_room) {
      room.size = Eigen::Vector3d(size[0], size[1], size[2]);
    } else {
      group.addError("size", "found " + group.required<Value>("size").text() +
                                 "; it should be [x, y, height] in metres, x and y 0.01 to 10000, "
                                 "and the height 0 (without walls) to 10000");
    }
  }
  room.tile = group.maybeBetween("tile", kSmallest, kLargest).value_or(room.tile);
  return room;
}

}  // namespace synthetic_dataset::config

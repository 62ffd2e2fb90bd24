#pragma once

#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "run/live/live_map.h"
#include "synthetic_dataset/value.h"
#include "world/description.h"

namespace synthetic_dataset::run {

/// The world that settings name, whatever else is right or wrong with them.
struct LiveWorld {
  std::string file;
  world::Description description;    ///< without what is missing
  std::vector<std::string> missing;  ///< what keeps the run from beginning with it
  LiveMap map;                       ///< from above; no picture where nothing is to be seen
  Eigen::AlignedBox3d bounds;        ///< of all that is to be seen; may be empty
};

/// Draws the map.
/// @param objects  models that leave the world: the run puts them elsewhere
[[nodiscard]] LiveMap mapOf(const world::Description& description,
                            const std::set<std::string>& objects);

/// Without the picture, for programs.
[[nodiscard]] Value::Map liveWorldValue(const LiveWorld& world);

}  // namespace synthetic_dataset::run

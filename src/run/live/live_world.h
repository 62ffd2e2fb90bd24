#pragma once

#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "randomize/placement/occupancy_map.h"
#include "synthetic_dataset/value.h"
#include "world/description.h"

namespace synthetic_dataset::run {

/// A picture from straight above: x to the right, y up.
struct LiveMap {
  cv::Mat picture;             ///< CV_8UC3
  Eigen::AlignedBox2d extent;  ///< that it covers [m], in the global frame
};

/// [x, y, x, y] of the lower left and of the upper right corner [m].
[[nodiscard]] Value extentValue(const Eigen::AlignedBox2d& extent);

/// Where a map is free (white), occupied (dark) and unknown (grey).
[[nodiscard]] LiveMap pictureOf(const randomize::OccupancyMap& map);

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

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
  Eigen::AlignedBox2d extent;  ///< area covered [m], in the global frame
};

/// [x, y, x, y] of the lower left and of the upper right corner [m].
[[nodiscard]] Value extentValue(const Eigen::AlignedBox2d& extent);

/// Draws a map's free (white), occupied (dark) and unknown (grey) areas.
[[nodiscard]] LiveMap pictureOf(const randomize::OccupancyMap& map);

/// The world that settings name, regardless of any other errors in them.
struct LiveWorld {
  std::string file;
  world::Description description;    ///< without what is missing
  std::vector<std::string> missing;  ///< what prevents the run from starting with it
  LiveMap map;                       ///< from above; no picture if nothing is visible
  Eigen::AlignedBox3d bounds;        ///< of everything visible; may be empty
};

/// Draws the map.
/// @param objects  models that are removed from the world because the run places them elsewhere
[[nodiscard]] LiveMap mapOf(const world::Description& description,
                            const std::set<std::string>& objects);

/// Without the picture, for programs.
[[nodiscard]] Value::Map liveWorldValue(const LiveWorld& world);

}  // namespace synthetic_dataset::run

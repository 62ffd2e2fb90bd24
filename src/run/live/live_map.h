#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "randomize/placement/occupancy_map.h"
#include "synthetic_dataset/value.h"

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

}  // namespace synthetic_dataset::run

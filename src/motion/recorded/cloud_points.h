#pragma once

#include <cstdint>
#include <vector>

#include <sensor_msgs/PointCloud2.h>
#include <Eigen/Core>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// What was measured at a point of a recorded cloud.
struct MeasuredPoint {
  Eigen::Vector3d position{0, 0, 0};  ///< in the header's frame [m]
  Duration time{0};                   ///< since the header's stamp
  double intensity = 0.0;             ///< as it was recorded; 0 where it was not
  std::uint32_t ring = 0;             ///< which beam; without a field, its row in the cloud
  std::uint32_t column = 0;           ///< how many cells of its ring come before it
};

/// A recorded cloud in which each point has its own time.
struct MeasuredCloud {
  std::vector<MeasuredPoint> points;  ///< in the message's order
  std::uint32_t rings = 0;            ///< more than any point's ring
  std::uint32_t columns = 0;          ///< more than any point's column
};

/// When points were measured, since the header's stamp.
struct TimeRange {
  Duration first{0};
  Duration last{0};
};

/// The positions of a cloud's points [m]. Those that are not finite are left out.
/// @throws Error where the message has no `x`, `y` and `z` of 32 or 64 bits for each point: "has no
///     field z; ..."
[[nodiscard]] std::vector<Eigen::Vector3d> positionsOf(const sensor_msgs::PointCloud2& cloud);

/// @throws Error as positionsOf does
void checkPositions(const sensor_msgs::PointCloud2& cloud);

/// A cloud's points, without those that are not finite or lie in the scanner, as drivers write
/// where nothing came back. Of the fields `intensity` and `reflectivity` the first that is there is
/// the intensity; `ring` or `line` is the ring.
///
/// Times are in the first of these fields that is there; without one, all are at the stamp:
/// - `time`, of floating point: seconds since the stamp (Velodyne's driver);
/// - `t`, a whole number: nanoseconds since the stamp (Ouster's);
/// - `timestamp`, of floating point: seconds (Hesai's, RoboSense's) or nanoseconds (Livox's) since
///   the epoch.
/// Where points are then farther than 1 s from the stamp, each field is tried as the others.
/// @throws Error as positionsOf does, and where times cannot be those of the stamp, or a ring is no
///     small number
[[nodiscard]] MeasuredCloud measuredCloud(const sensor_msgs::PointCloud2& cloud);

/// When the points of measuredCloud() were measured; nothing but the stamp where there are none.
/// @throws Error as measuredCloud does
[[nodiscard]] TimeRange timesOf(const sensor_msgs::PointCloud2& cloud);

}  // namespace synthetic_dataset::motion

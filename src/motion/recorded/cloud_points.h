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
  Duration time{0};                   ///< relative to the header's stamp
  double intensity = 0.0;             ///< as it was recorded; 0 if it was not
  std::uint32_t ring = 0;             ///< number of the beam; without a field for it, the row in
                                      ///< the cloud
  std::uint32_t column = 0;           ///< number of cells of its ring before it
};

/// A recorded cloud in which each point has its own time.
struct MeasuredCloud {
  std::vector<MeasuredPoint> points;  ///< in the message's order
  std::uint32_t rings = 0;            ///< greater than any point's ring
  std::uint32_t columns = 0;          ///< greater than any point's column
};

/// When points were measured, relative to the header's stamp.
struct TimeRange {
  Duration first{0};
  Duration last{0};
};

/// The positions of a cloud's points [m]. Those that are not finite are left out.
/// @throws Error if the message has no `x`, `y` and `z` of 32 or 64 bits for each point: "has no
///     field z; ..."
[[nodiscard]] std::vector<Eigen::Vector3d> positionsOf(const sensor_msgs::PointCloud2& cloud);

/// @throws Error as positionsOf does
void checkPositions(const sensor_msgs::PointCloud2& cloud);

/// A cloud's points, without those that are not finite or lie at the scanner's origin, which
/// drivers write if nothing came back. The intensity is the first of the fields `intensity` and
/// `reflectivity` that exists, the ring the first of `ring` and `line`.
///
/// Times are in the first of these fields that exists; without any, all points are at the stamp:
/// - `time`, of floating point: seconds since the stamp (Velodyne's driver);
/// - `t`, a whole number: nanoseconds since the stamp (Ouster's);
/// - `timestamp`, of floating point: seconds (Hesai's, RoboSense's) or nanoseconds (Livox's) since
///   the epoch.
/// If points are then more than 1 s from the stamp, the other interpretations are tried for the
/// field.
/// @throws Error as positionsOf does, and if times do not fit the stamp, or a ring is not a small
///     number
[[nodiscard]] MeasuredCloud measuredCloud(const sensor_msgs::PointCloud2& cloud);

/// When the points of measuredCloud() were measured; only the stamp if there are none.
/// @throws Error as measuredCloud does
[[nodiscard]] TimeRange timesOf(const sensor_msgs::PointCloud2& cloud);

}  // namespace synthetic_dataset::motion

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "motion/bag/message_index.h"
#include "motion/recorded/cloud_points.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// What is known of a cloud without keeping its points.
struct CloudHead {
  Stamp stamp{0};            ///< that its message's header has
  std::string frame;         ///< likewise, without leading slashes
  std::string problem = {};  ///< why it cannot be read: "has no field z, ..."

  TimeRange times = {};           ///< of its points
  std::string time_problem = {};  ///< why nobody knows them: "has points of the times ..."
};

/// The clouds of a topic of type sensor_msgs/PointCloud2, in bags that count as one recording.
class RecordedClouds : public RecordedMessages<CloudHead> {
 public:
  /// Looks at all messages of the topic, and keeps where they are.
  /// @throws Error as RecordedPictures does
  RecordedClouds(const std::vector<std::string>& bag_files, const std::string& topic);

  /// The points of a cloud of heads() [m], in any thread; those that are not finite are left out.
  /// @throws Error where it cannot be read
  [[nodiscard]] std::vector<Eigen::Vector3d> read(std::size_t index) const;

  /// What was measured at them, likewise.
  [[nodiscard]] MeasuredCloud readMeasured(std::size_t index) const;
};

}  // namespace synthetic_dataset::motion

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "motion/bag/message_index.h"
#include "motion/recorded/cloud_points.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A summary of a cloud, without its points.
struct CloudHead {
  Stamp stamp{0};            ///< of the message's header
  std::string frame;         ///< of the header, without leading slashes
  std::string problem = {};  ///< why it cannot be read: "has no field z, ..."

  TimeRange times = {};           ///< of its points
  std::string time_problem = {};  ///< why they are not known: "has points of the times ..."
};

/// The clouds of a topic of type sensor_msgs/PointCloud2, in bags that count as one recording.
class RecordedClouds : public RecordedMessages<CloudHead> {
 public:
  /// Looks at all messages of the topic, and remembers where they are.
  /// @throws Error as RecordedPictures does
  RecordedClouds(const std::vector<std::string>& bag_files, const std::string& topic);

  /// The points of a cloud of heads() [m], without those that are not finite. May be called in any
  /// thread.
  /// @throws Error if it cannot be read
  [[nodiscard]] std::vector<Eigen::Vector3d> read(std::size_t index) const;

  /// What was measured at the points; see measuredCloud(). May be called in any thread.
  [[nodiscard]] MeasuredCloud readMeasured(std::size_t index) const;
};

}  // namespace synthetic_dataset::motion

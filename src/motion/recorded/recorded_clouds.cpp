#include "motion/recorded/recorded_clouds.h"

#include <sensor_msgs/PointCloud2.h>

#include "motion/bag/checked_messages.h"
#include "motion/bag/ros_time.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

using sensor_msgs::PointCloud2;

/// The message of an Error that a step throws; empty if it throws none.
template <class Step>
std::string problemIn(const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

CloudHead cloudHeadOf(const BagMessage& message) {
  const auto recorded = message.instantiate<RecordedCloud>();
  if (!recorded) throw Error("a message of '" + message.topic + "' is not a cloud");
  const PointCloud2& cloud = recorded->message;
  CloudHead head{toStamp(cloud.header.stamp), withoutLeadingSlashes(cloud.header.frame_id)};
  head.problem = problemIn([&] { checkPositions(cloud); });
  head.time_problem = problemIn([&] { head.times = timesOf(cloud); });
  return head;
}

}  // namespace

RecordedClouds::RecordedClouds(const std::vector<std::string>& bag_files, const std::string& topic)
    : RecordedMessages(bag_files, topic, "cloud", TopicSearch::of<PointCloud2>(topic),
                       cloudHeadOf) {}

std::vector<Eigen::Vector3d> RecordedClouds::read(std::size_t index) const {
  std::vector<Eigen::Vector3d> points;
  show(index, [&](const BagMessage& message) {
    const auto cloud = message.instantiate<RecordedCloud>();
    if (cloud) points = positionsOf(cloud->message);
  });
  return points;
}

MeasuredCloud RecordedClouds::readMeasured(std::size_t index) const {
  MeasuredCloud measured;
  show(index, [&](const BagMessage& message) {
    const auto cloud = message.instantiate<RecordedCloud>();
    if (cloud) measured = measuredCloud(cloud->message);
  });
  return measured;
}

}  // namespace synthetic_dataset::motion

#include "motion/recorded/recorded_clouds.h"

#include <optional>
#include <utility>

#include <sensor_msgs/PointCloud2.h>

#include "motion/bag/checked_messages.h"
#include "motion/bag/message_index.h"
#include "motion/bag/ros_time.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

using sensor_msgs::PointCloud2;

/// What an Error of a step says; nothing where there is none.
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
  if (!recorded) throw Error("a message of '" + message.topic + "' is no cloud");
  const PointCloud2& cloud = recorded->message;
  CloudHead head{toStamp(cloud.header.stamp), withoutLeadingSlashes(cloud.header.frame_id)};
  head.problem = problemIn([&] { checkPositions(cloud); });
  head.time_problem = problemIn([&] { head.times = timesOf(cloud); });
  return head;
}

}  // namespace

struct RecordedClouds::Impl {
  std::vector<CloudHead> heads;
  std::optional<MessageIndex> messages;  ///< of heads
};

RecordedClouds::RecordedClouds(const std::vector<std::string>& bag_files, const std::string& topic)
    : impl_(std::make_unique<Impl>()) {
  std::vector<CloudHead> looked_at;
  impl_->messages.emplace(bag_files, topic, "cloud", TopicSearch::of<PointCloud2>(topic),
                          [&](const BagMessage& message) {
                            looked_at.push_back(cloudHeadOf(message));
                            return looked_at.back().stamp;
                          });
  impl_->heads = impl_->messages->inOrder(std::move(looked_at));
}

RecordedClouds::~RecordedClouds() = default;
RecordedClouds::RecordedClouds(RecordedClouds&&) noexcept = default;
RecordedClouds& RecordedClouds::operator=(RecordedClouds&&) noexcept = default;

const std::vector<CloudHead>& RecordedClouds::heads() const { return impl_->heads; }

std::int64_t RecordedClouds::repeatedCount() const { return impl_->messages->repeatedCount(); }

std::vector<Eigen::Vector3d> RecordedClouds::read(std::size_t index) const {
  std::vector<Eigen::Vector3d> points;
  impl_->messages->read(index, [&](const BagMessage& message) {
    const auto cloud = message.instantiate<RecordedCloud>();
    if (cloud) points = positionsOf(cloud->message);
  });
  return points;
}

MeasuredCloud RecordedClouds::readMeasured(std::size_t index) const {
  MeasuredCloud measured;
  impl_->messages->read(index, [&](const BagMessage& message) {
    const auto cloud = message.instantiate<RecordedCloud>();
    if (cloud) measured = measuredCloud(cloud->message);
  });
  return measured;
}

}  // namespace synthetic_dataset::motion

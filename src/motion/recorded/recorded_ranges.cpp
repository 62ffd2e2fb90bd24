#include "motion/recorded/recorded_ranges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include <sensor_msgs/PointCloud2.h>

#include "base/image/depth_picture.h"
#include "motion/bag/checked_messages.h"
#include "motion/bag/message_index.h"
#include "motion/bag/ros_time.h"
#include "motion/frame_names.h"
#include "motion/recorded/recorded_pictures.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

std::size_t sizeOf(const PointField& field) {
  return field.datatype == PointField::FLOAT64 ? sizeof(double) : sizeof(float);
}

/// The fields x, y and z.
/// @throws Error where one is missing, or no number with a point
std::array<PointField, 3> coordinatesOf(const PointCloud2& cloud) {
  std::array<PointField, 3> found;
  const char* const names[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                    [&](const PointField& each) { return each.name == names[i]; });
    std::string there;
    for (const PointField& each : cloud.fields) there += (there.empty() ? "" : ", ") + each.name;
    if (field == cloud.fields.end()) {
      throw Error("has no field " + std::string(names[i]) + "; it has " +
                  (there.empty() ? "none" : there) + ", and x, y, z are needed");
    }
    if (field->datatype != PointField::FLOAT32 && field->datatype != PointField::FLOAT64) {
      throw Error("has a field " + field->name + " of type " + std::to_string(field->datatype) +
                  "; it should be FLOAT32 (7) or FLOAT64 (8)");
    }
    if (std::uint64_t{field->offset} + sizeOf(*field) > cloud.point_step) {
      throw Error("has points of " + std::to_string(cloud.point_step) +
                  " bytes (point_step), and its field " + field->name + " ends at " +
                  std::to_string(std::uint64_t{field->offset} + sizeOf(*field)));
    }
    found[i] = *field;
  }
  return found;
}

/// @throws Error where it cannot be read
void checkPoints(const PointCloud2& cloud) {
  (void)coordinatesOf(cloud);
  const std::uint64_t row = std::uint64_t{cloud.point_step} * cloud.width;
  if (cloud.height > 1 && cloud.row_step < row) {
    throw Error("has rows of " + std::to_string(cloud.row_step) + " bytes (row_step); its " +
                std::to_string(cloud.width) + " points need " + std::to_string(row));
  }
  if (cloud.height == 0 || cloud.width == 0) return;
  const std::uint64_t needed = std::uint64_t{cloud.row_step} * (cloud.height - 1) + row;
  if (cloud.data.size() >= needed) return;
  throw Error("has " + std::to_string(cloud.data.size()) + " bytes; its " +
              std::to_string(cloud.width) + " x " + std::to_string(cloud.height) + " points need " +
              std::to_string(needed));
}

template <class Number>
double numberAt(const std::uint8_t* bytes, bool is_bigendian) {
  std::array<std::uint8_t, sizeof(Number)> in_order{};
  std::copy_n(bytes, in_order.size(), in_order.begin());
  if (is_bigendian) std::reverse(in_order.begin(), in_order.end());
  Number number{};
  std::memcpy(&number, in_order.data(), sizeof number);
  return static_cast<double>(number);
}

std::vector<Eigen::Vector3d> pointsOf(const PointCloud2& cloud) {
  checkPoints(cloud);
  const std::array<PointField, 3> fields = coordinatesOf(cloud);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t row = 0; row < cloud.height; ++row) {
    for (std::size_t i = 0; i < cloud.width; ++i) {
      const std::uint8_t* const at =
          cloud.data.data() + row * cloud.row_step + i * cloud.point_step;
      Eigen::Vector3d point;
      for (std::size_t axis = 0; axis < fields.size(); ++axis) {
        const std::uint8_t* const bytes = at + fields[axis].offset;
        const bool is_double = fields[axis].datatype == PointField::FLOAT64;
        point[static_cast<Eigen::Index>(axis)] =
            is_double ? numberAt<double>(bytes, cloud.is_bigendian != 0)
                      : numberAt<float>(bytes, cloud.is_bigendian != 0);
      }
      if (point.allFinite()) points.push_back(point);
    }
  }
  return points;
}

CloudHead cloudHeadOf(const BagMessage& message) {
  const auto recorded = message.instantiate<RecordedCloud>();
  if (!recorded) throw Error("a message of '" + message.topic + "' is no cloud");
  const PointCloud2& cloud = recorded->message;
  CloudHead head{toStamp(cloud.header.stamp), withoutLeadingSlashes(cloud.header.frame_id)};
  try {
    checkPoints(cloud);
  } catch (const Error& error) {
    head.problem = error.what();
  }
  return head;
}

}  // namespace

struct RecordedDepths::Impl {
  std::vector<PictureHead> heads;
  std::optional<MessageIndex> messages;  ///< of heads
};

RecordedDepths::RecordedDepths(const std::vector<std::string>& bag_files, const std::string& topic)
    : impl_(std::make_unique<Impl>()) {
  std::vector<PictureHead> looked_at;
  impl_->messages.emplace(
      bag_files, topic, "depth image",
      TopicSearch::of<sensor_msgs::Image, sensor_msgs::CompressedImage>(topic),
      [&](const BagMessage& message) {
        looked_at.push_back(
            headOf(framedPicture(message), base::depthProblem, [](const PictureFile& file) {
              return base::checkCompressedDepth(file.bytes, file.format);
            }));
        return looked_at.back().stamp;
      });
  impl_->heads = impl_->messages->inOrder(std::move(looked_at));
}

RecordedDepths::~RecordedDepths() = default;
RecordedDepths::RecordedDepths(RecordedDepths&&) noexcept = default;
RecordedDepths& RecordedDepths::operator=(RecordedDepths&&) noexcept = default;

const std::vector<PictureHead>& RecordedDepths::heads() const { return impl_->heads; }

cv::Mat RecordedDepths::read(std::size_t index) const {
  cv::Mat depth;
  impl_->messages->read(index, [&](const BagMessage& message) {
    const RecordedPicture picture = framedPicture(message).picture;
    const auto* file = std::get_if<PictureFile>(&picture);
    depth = file != nullptr ? base::depthOfCompressed(file->bytes, file->format)
                            : base::depthOf(std::get<base::RawPicture>(picture));
  });
  return depth;
}

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

std::vector<Eigen::Vector3d> RecordedClouds::read(std::size_t index) const {
  std::vector<Eigen::Vector3d> points;
  impl_->messages->read(index, [&](const BagMessage& message) {
    const auto cloud = message.instantiate<RecordedCloud>();
    if (cloud) points = pointsOf(cloud->message);
  });
  return points;
}

}  // namespace synthetic_dataset::motion

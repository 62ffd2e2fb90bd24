#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <sensor_msgs/PointCloud2.h>

#include "motion/bag/ros_time.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::test {

/// A field of a cloud, with a number for each of its points.
struct CloudFieldNumbers {
  std::string name;
  std::uint8_t type = sensor_msgs::PointField::FLOAT32;
  std::vector<double> numbers;
};

enum class ByteOrder { kLittle, kBig };

/// Writes a number in a field's type and byte order.
template <class Number>
void putNumber(double value, ByteOrder order, std::uint8_t* bytes) {
  const auto number = static_cast<Number>(value);
  std::memcpy(bytes, &number, sizeof number);
  if (order == ByteOrder::kBig) std::reverse(bytes, bytes + sizeof number);
}

/// A sensor_msgs/PointCloud2 with a byte of padding before each field and three after each row.
/// @param height  number of rows, among which the points are shared evenly
inline sensor_msgs::PointCloud2 cloudMessage(const std::string& frame, Stamp stamp,
                                             const std::vector<CloudFieldNumbers>& fields,
                                             ByteOrder order = ByteOrder::kLittle,
                                             std::uint32_t height = 1) {
  using sensor_msgs::PointField;
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = frame;
  cloud.header.stamp = motion::toRosTime(stamp);
  cloud.is_bigendian = order == ByteOrder::kBig ? 1 : 0;
  cloud.height = height;
  cloud.width = static_cast<std::uint32_t>(fields.front().numbers.size()) / height;
  constexpr std::uint32_t kSizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
  for (const CloudFieldNumbers& each : fields) {
    PointField& field = cloud.fields.emplace_back();
    field.name = each.name;
    field.offset = cloud.point_step + 1;
    field.datatype = each.type;
    field.count = 1;
    cloud.point_step = field.offset + kSizes[each.type];
  }
  cloud.row_step = cloud.point_step * cloud.width + 3;
  cloud.data.resize(std::size_t{cloud.row_step} * height);
  for (std::uint32_t i = 0; i < cloud.width * height; ++i) {
    for (std::size_t f = 0; f < fields.size(); ++f) {
      std::uint8_t* const bytes =
          &cloud.data[i / cloud.width * std::size_t{cloud.row_step} +
                      i % cloud.width * std::size_t{cloud.point_step} + cloud.fields[f].offset];
      const double number = fields[f].numbers[i];
      switch (fields[f].type) {
        case PointField::UINT8:
          putNumber<std::uint8_t>(number, order, bytes);
          break;
        case PointField::UINT16:
          putNumber<std::uint16_t>(number, order, bytes);
          break;
        case PointField::INT32:
          putNumber<std::int32_t>(number, order, bytes);
          break;
        case PointField::UINT32:
          putNumber<std::uint32_t>(number, order, bytes);
          break;
        case PointField::FLOAT64:
          putNumber<double>(number, order, bytes);
          break;
        default:
          putNumber<float>(number, order, bytes);
      }
    }
  }
  return cloud;
}

}  // namespace synthetic_dataset::test

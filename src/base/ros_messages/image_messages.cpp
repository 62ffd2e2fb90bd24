#include "base/ros_messages/image_messages.h"

#include <cstddef>
#include <cstdint>
#include <limits>

#include <sensor_msgs/image_encodings.h>

namespace synthetic_dataset::ros_messages {

sensor_msgs::Image imageMessage(const std_msgs::Header& header, const std::string& encoding,
                                const cv::Mat& pixels) {
  sensor_msgs::Image message;
  message.header = header;
  message.width = static_cast<std::uint32_t>(pixels.cols);
  message.height = static_cast<std::uint32_t>(pixels.rows);
  message.encoding = encoding;
  message.is_bigendian = 0;
  const std::size_t row_size = static_cast<std::size_t>(pixels.cols) * pixels.elemSize();
  message.step = static_cast<std::uint32_t>(row_size);
  message.data.reserve(row_size * message.height);
  for (int row = 0; row < pixels.rows; ++row) {
    message.data.insert(message.data.end(), pixels.ptr(row), pixels.ptr(row) + row_size);
  }
  return message;
}

sensor_msgs::Image depthMessage(const std_msgs::Header& header, const cv::Mat& depth) {
  cv::Mat known = depth.clone();
  known.setTo(std::numeric_limits<float>::quiet_NaN(), depth == 0.0F);
  return imageMessage(header, sensor_msgs::image_encodings::TYPE_32FC1, known);
}

}  // namespace synthetic_dataset::ros_messages

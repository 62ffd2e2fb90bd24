#include "plugins/ros_bag/bag_recording.h"

#include <cstdint>

#include <sensor_msgs/CompressedImage.h>
#include <opencv2/imgcodecs.hpp>

#include "base/ros_messages/image_messages.h"
#include "synthetic_dataset/errors.h"

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#include <sanitizer/lsan_interface.h>
#define SYNTHETIC_DATASET_LEAK_CHECK
#endif
#endif

namespace synthetic_dataset {
namespace {

/// Leaks a bag on purpose: it stays open.
void abandon(const rosbag::Bag* bag) {
#ifdef SYNTHETIC_DATASET_LEAK_CHECK
  __lsan_ignore_object(bag);
#else
  (void)bag;
#endif
}

cv::Mat decoded(const std::string& encoded) {
  const std::vector<std::uint8_t> bytes(encoded.begin(), encoded.end());
  cv::Mat pixels = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  if (pixels.empty()) throw Error("a picture of a scene cannot be read again");
  return pixels;
}

}  // namespace

BagRecording::BagRecording(const std::string& file, rosbag::CompressionType compression)
    : bag_(std::make_unique<rosbag::Bag>()) {
  bag_->open(file, rosbag::bagmode::Write);
  bag_->setCompression(compression);
}

BagRecording::~BagRecording() {
  try {
    bag_->close();
  } catch (const std::exception&) {
    // For example, the disk is full. rosbag::Bag's destructor would try again, and an exception
    // thrown there would terminate the program before the error is reported.
    abandon(bag_.release());
  }
}

void BagRecording::writeImage(const std::string& topic, const std_msgs::Header& header,
                              const std::string& encoding, const std::string& encoded) {
  write(topic, ros_messages::imageMessage(header, encoding, decoded(encoded)));
}

void BagRecording::writeDepth(const std::string& topic, const std_msgs::Header& header,
                              const std::string& encoded) {
  write(topic, ros_messages::depthMessage(header, decoded(encoded)));
}

void BagRecording::writeCompressed(const std::string& topic, const std_msgs::Header& header,
                                   const std::string& encoded) {
  sensor_msgs::CompressedImage message;
  message.header = header;
  message.format = "bgr8; png compressed bgr8";  // as in compressed_image_transport
  message.data.assign(encoded.begin(), encoded.end());
  write(topic, message);
}

void BagRecording::close() { bag_->close(); }

}  // namespace synthetic_dataset

#pragma once

#include <memory>
#include <string>

#include <rosbag/bag.h>
#include <std_msgs/Header.h>

namespace synthetic_dataset {

/// A new ROS bag. http://wiki.ros.org/Bags/Format/2.0
class BagRecording {
 public:
  /// @throws rosbag::BagException, as the other methods do, when the disk is full
  BagRecording(const std::string& file, rosbag::CompressionType compression);
  ~BagRecording();
  BagRecording(const BagRecording&) = delete;
  BagRecording& operator=(const BagRecording&) = delete;

  /// Recorded at the stamp in its header.
  template <class Message>
  void write(const std::string& topic, const Message& message) {
    write(topic, message.header.stamp, message);
  }
  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    bag_->write(topic, time, message);  // without a connection header: nobody's name gets in
  }

  /// The pixels of an encoded picture as sensor_msgs/Image.
  /// @param encoding  of sensor_msgs/image_encodings.h
  void writeImage(const std::string& topic, const std_msgs::Header& header,
                  const std::string& encoding, const std::string& encoded);

  /// The same of a picture of depths, 0 where nothing is: not a number then, as REP 117 and
  /// depth_image_proc have it.
  void writeDepth(const std::string& topic, const std_msgs::Header& header,
                  const std::string& encoded);

  /// A PNG in colours, as it is, as sensor_msgs/CompressedImage.
  void writeCompressed(const std::string& topic, const std_msgs::Header& header,
                       const std::string& encoded);

  /// The bag is whole only then.
  void close();

 private:
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace synthetic_dataset

#pragma once

#include <memory>
#include <string>

#include <rosbag/bag.h>
#include <std_msgs/Header.h>

namespace synthetic_dataset {

/// A new ROS bag. http://wiki.ros.org/Bags/Format/2.0
class BagRecording {
 public:
  /// @throws rosbag::BagException if the disk is full, as do the other methods
  BagRecording(const std::string& file, rosbag::CompressionType compression);
  ~BagRecording();
  BagRecording(const BagRecording&) = delete;
  BagRecording& operator=(const BagRecording&) = delete;

  /// Writes a message at the stamp in its header.
  template <class Message>
  void write(const std::string& topic, const Message& message) {
    write(topic, message.header.stamp, message);
  }
  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    bag_->write(topic, time, message);  // without a connection header: stores no node name
  }

  /// Writes the pixels of an encoded picture as sensor_msgs/Image.
  /// @param encoding  one of sensor_msgs/image_encodings.h
  void writeImage(const std::string& topic, const std_msgs::Header& header,
                  const std::string& encoding, const std::string& encoded);

  /// Writes a depth picture; 0, where there is nothing, becomes NaN, as in REP 117 and
  /// depth_image_proc.
  void writeDepth(const std::string& topic, const std_msgs::Header& header,
                  const std::string& encoded);

  /// Writes a colour PNG unchanged as sensor_msgs/CompressedImage.
  void writeCompressed(const std::string& topic, const std_msgs::Header& header,
                       const std::string& encoded);

  /// The bag is only complete after this.
  void close();

 private:
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace synthetic_dataset

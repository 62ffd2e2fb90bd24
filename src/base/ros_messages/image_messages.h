#pragma once

#include <string>

#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>
#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::ros_messages {

/// An image's pixels, row by row.
/// @param encoding  of sensor_msgs/image_encodings.h, matching the pixels' type: bgr8 for
///     Scene::image, mono16 for Scene::instance_map
[[nodiscard]] sensor_msgs::Image imageMessage(const std_msgs::Header& header,
                                              const std::string& encoding, const cv::Mat& pixels);

/// Depths [m] from CV_32FC1, in which 0 means no surface; such pixels become NaN, as in REP 117 and
/// depth_image_proc.
[[nodiscard]] sensor_msgs::Image depthMessage(const std_msgs::Header& header, const cv::Mat& depth);

}  // namespace synthetic_dataset::ros_messages

#pragma once

#include <string>

#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>
#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::ros_messages {

/// An image's pixels, row by row.
/// @param encoding  of sensor_msgs/image_encodings.h, as the pixels' type is: Scene::image is bgr8,
///     Scene::instance_map mono16
[[nodiscard]] sensor_msgs::Image imageMessage(const std_msgs::Header& header,
                                              const std::string& encoding, const cv::Mat& pixels);

/// Depths [m] in CV_32FC1, 0 where nothing is: not a number then, as REP 117 and depth_image_proc
/// have it.
[[nodiscard]] sensor_msgs::Image depthMessage(const std_msgs::Header& header, const cv::Mat& depth);

}  // namespace synthetic_dataset::ros_messages

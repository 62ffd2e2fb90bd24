#pragma once

#include <map>
#include <string>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/cloud.h"

namespace synthetic_dataset::base {

/// The stored values of clouds, point by point, as pictures of one column, by name; the number is
/// the lidar's index:
/// "cloud_0": x, y, z [m] at the stamp and the intensity, CV_32FC4;
/// "cloud_0_measured": the same as measured;
/// "cloud_0_labels": instance, class and class of the world, CV_16UC3.
[[nodiscard]] std::map<std::string, cv::Mat> cloudPictures(const Clouds& clouds);

}  // namespace synthetic_dataset::base

#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"

namespace synthetic_dataset {

/// A box with what is written on it.
struct DrawnBox {
  std::string caption;
  Box box;  ///< [px]
};

/// A mask and keypoints of one object.
struct DrawnObject {
  cv::Mat mask;                        ///< CV_8UC1, 0 or 255; empty for none
  std::vector<cv::Point2d> keypoints;  ///< [px]
};

/// The picture with masks tinted over it, dots on the keypoints and boxes round the objects.
/// @param image  CV_8UC3
[[nodiscard]] cv::Mat drawLabels(const cv::Mat& image, const std::vector<DrawnObject>& objects,
                                 const std::vector<DrawnBox>& boxes);

}  // namespace synthetic_dataset

#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::formats {

/// One object as a format's files have it, in OpenCV's pixel coordinates: a pixel's centre is
/// whole.
struct DrawnLabel {
  std::string caption;  ///< its class, and what else the format says
  std::optional<Box> box;
  cv::Mat mask;                                    ///< CV_8UC1; empty: none
  std::vector<std::vector<cv::Point2d>> polygons;  ///< closed
  std::vector<cv::Point2d> keypoints;              ///< that are to be seen
  std::vector<cv::Point2d> hidden_keypoints;       ///< that are said to be hidden
  std::vector<std::array<cv::Point2d, 2>> lines;   ///< edges of cuboids, skeletons, axes

  // What the files say of it, word for word.
  std::vector<std::string> class_names;  ///< any of these, where they do not tell them apart
  std::string object_name;               ///< empty: not which object it is
  std::optional<Pose> X_CO;              ///< in the camera's optical frame [m]

  /// Labels of the same number have the same colour; none: one of its own.
  std::optional<std::size_t> colour = std::nullopt;
};

/// A scene's image with its labels, as one format's files have them.
struct LabelledPicture {
  cv::Mat image;  ///< CV_8UC3
  std::vector<DrawnLabel> labels;
};

}  // namespace synthetic_dataset::formats

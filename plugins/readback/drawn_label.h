#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::formats {

/// One object as described by a format's files, in OpenCV's pixel coordinates: pixel centres have
/// integer coordinates.
struct DrawnLabel {
  std::string caption;  ///< its class, and whatever else the format says
  std::optional<Box> box;
  cv::Mat mask;                                    ///< CV_8UC1; empty: none
  std::vector<std::vector<cv::Point2d>> polygons;  ///< closed
  std::vector<cv::Point2d> keypoints;              ///< visible ones
  std::vector<cv::Point2d> hidden_keypoints;       ///< ones marked as hidden
  std::vector<std::array<cv::Point2d, 2>> lines;   ///< edges of cuboids, skeletons, axes

  // What the files say about it, verbatim.
  std::vector<std::string> class_names;  ///< several if the files do not distinguish them
  std::string object_name;               ///< empty: the files do not identify the object
  std::optional<Pose> X_CO;              ///< in the camera's optical frame [m]

  /// Labels with the same number have the same colour; nothing: a colour of its own.
  std::optional<std::size_t> colour = std::nullopt;
};

/// A scene's image with its labels, as read from one format's files.
struct LabelledPicture {
  cv::Mat image;  ///< CV_8UC3
  std::vector<DrawnLabel> labels;
};

}  // namespace synthetic_dataset::formats

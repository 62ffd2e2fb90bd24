#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "plugins/readback/labelled_cloud.h"

namespace synthetic_dataset::formats {

/// The colour of a class in pictures of a cloud.
struct ClassColour {
  cv::Scalar colour;  ///< blue green red
  bool is_of_world = false;
};

/// The colour of points without a class, or whose class is unknown.
inline const cv::Scalar kUnlabelledColour = cv::Scalar::all(130);

/// The colour of each class of a cloud, by its number: for objects the same as for labels in
/// images, for the world duller.
/// @param object_classes  of the dataset, in order: a class's index determines its colour
[[nodiscard]] std::map<std::uint16_t, ClassColour> classColours(
    const LabelledCloud& cloud, const std::vector<std::string>& object_classes);

}  // namespace synthetic_dataset::formats

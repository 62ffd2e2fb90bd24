#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "plugins/readback/labelled_cloud.h"

namespace synthetic_dataset::formats {

/// What pictures of a cloud show a class in.
struct ClassColour {
  cv::Scalar colour;  ///< blue green red
  bool is_of_world = false;
};

/// Points of no class, and those of which nothing is said.
inline const cv::Scalar kUnlabelledColour = cv::Scalar::all(130);

/// The colour of each class of a cloud, by its number: those of objects as labels in images have
/// them, those of the world duller.
/// @param object_classes  of the dataset, in their order: a class has the colour of its place
[[nodiscard]] std::map<std::uint16_t, ClassColour> classColours(
    const LabelledCloud& cloud, const std::vector<std::string>& object_classes);

}  // namespace synthetic_dataset::formats

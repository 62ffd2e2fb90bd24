#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "plugins/readback/labelled_cloud.h"

namespace synthetic_dataset::formats {

/// Draws a cloud for the eye: from above with a legend that has its numbers, and below the range
/// image with ranges and with labels. Of the same size whatever the cloud is.
/// @param cloud  in which points that are no numbers may be
/// @param object_classes  of the dataset, as `classColours` takes them
[[nodiscard]] cv::Mat drawCloud(LabelledCloud cloud,
                                const std::vector<std::string>& object_classes);

}  // namespace synthetic_dataset::formats

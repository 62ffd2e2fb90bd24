#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "plugins/readback/labelled_cloud.h"

namespace synthetic_dataset::formats {

/// Draws a cloud for viewing: from above, with a legend that gives point counts, and below this the
/// range image with ranges and with labels. The size does not depend on the cloud.
/// @param cloud  may contain points that are not numbers
/// @param object_classes  as for `classColours`
[[nodiscard]] cv::Mat drawCloud(LabelledCloud cloud,
                                const std::vector<std::string>& object_classes);

}  // namespace synthetic_dataset::formats

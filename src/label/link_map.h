#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::label {

/// What number the link has that each pixel shows; 0 where there is nothing. CV_16UC1.
/// @param links  CV_32SC1: a link's index + 1, 0 for nothing
/// @param numbers  of the links, in their order
[[nodiscard]] cv::Mat mapOfLinks(const cv::Mat& links, const std::vector<std::uint16_t>& numbers);

}  // namespace synthetic_dataset::label

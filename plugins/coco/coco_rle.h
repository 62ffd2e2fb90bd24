#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::formats::coco {

/// Decodes a mask from COCO's compressed run lengths: CV_8UC1, 255 on the mask.
/// @throws Error if they do not encode a mask of this size
[[nodiscard]] cv::Mat maskOfCocoCounts(const std::string& counts, const cv::Size& size);

}  // namespace synthetic_dataset::formats::coco

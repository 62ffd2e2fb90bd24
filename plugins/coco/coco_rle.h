#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::formats::coco {

/// The mask that COCO's compressed run lengths stand for: CV_8UC1, 255 on it.
/// @throws Error where they are not those of a mask of this size
[[nodiscard]] cv::Mat maskOfCocoCounts(const std::string& counts, const cv::Size& size);

}  // namespace synthetic_dataset::formats::coco

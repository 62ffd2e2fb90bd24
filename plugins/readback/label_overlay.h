#pragma once

#include <opencv2/core/mat.hpp>

#include "plugins/readback/drawn_label.h"

namespace synthetic_dataset::formats {

/// The picture with its labels on it, for the eye: tinted masks, outlines, boxes with captions,
/// lines, keypoints (hollow where they are hidden).
/// @throws Error where a mask is not of the picture's size
[[nodiscard]] cv::Mat drawLabels(const LabelledPicture& picture);

}  // namespace synthetic_dataset::formats

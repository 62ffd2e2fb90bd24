#pragma once

#include <cstddef>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "plugins/readback/drawn_label.h"

namespace synthetic_dataset::formats {

/// The colour of labels of a number, as DrawnLabel::colour, blue green red. After a few, they
/// repeat.
[[nodiscard]] cv::Scalar labelColour(std::size_t number);

/// The picture with its labels on it, for the eye: tinted masks, outlines, boxes with captions,
/// lines, keypoints (hollow where they are hidden).
/// @throws Error where a mask is not of the picture's size
[[nodiscard]] cv::Mat drawLabels(const LabelledPicture& picture);

}  // namespace synthetic_dataset::formats

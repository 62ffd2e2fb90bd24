#pragma once

#include <cstddef>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "plugins/readback/drawn_label.h"

namespace synthetic_dataset::formats {

/// The colour of labels with a number (DrawnLabel::colour), blue green red. The colours repeat
/// after a few numbers.
[[nodiscard]] cv::Scalar labelColour(std::size_t number);

/// The picture with its labels drawn on it, for viewing: tinted masks, outlines, boxes with
/// captions, lines, keypoints (hollow if hidden).
/// @throws Error if a mask is not of the picture's size
[[nodiscard]] cv::Mat drawLabels(const LabelledPicture& picture);

}  // namespace synthetic_dataset::formats

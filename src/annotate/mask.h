#pragma once

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"

namespace synthetic_dataset::annotate {

/// The pixels [floor(left), ceil(right)) by [floor(top), ceil(bottom)) of a box, as far as they are
/// in the image; an empty rectangle where none is.
[[nodiscard]] cv::Rect pixelsOf(const Box& box, const cv::Size& image);

/// A raw background subtraction made into an instance mask, 0 or 255:
/// - shadow (127) is not the object;
/// - holes of at most `kLargestHole` pixels are filled: there the object happens to have the
///   background's colour;
/// - specks of at most `kLargestSpeck` pixels are removed, unless that would leave nothing.
/// Outlines are left as they are, so a mask without holes and specks stays bit for bit the same.
/// @param raw  CV_8UC1 as Mog2Segmenter gives it
[[nodiscard]] cv::Mat cleanMask(const cv::Mat& raw);

inline constexpr int kLargestHole = 24;
inline constexpr int kLargestSpeck = 3;

}  // namespace synthetic_dataset::annotate

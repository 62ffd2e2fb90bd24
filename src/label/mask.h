#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::label {

/// Turns a raw background subtraction into an instance mask, 0 or 255:
/// - shadow (127) does not belong to the object;
/// - holes of at most `kLargestHole` pixels are filled: there the object happens to have the
///   background's colour;
/// - specks of at most `kLargestSpeck` pixels are removed, unless that would leave nothing.
/// Outlines are left as they are, so a mask without holes and specks stays bit for bit the same.
/// @param raw  CV_8UC1 from Mog2Segmenter
[[nodiscard]] cv::Mat cleanMask(const cv::Mat& raw);

inline constexpr int kLargestHole = 24;
inline constexpr int kLargestSpeck = 3;

}  // namespace synthetic_dataset::label

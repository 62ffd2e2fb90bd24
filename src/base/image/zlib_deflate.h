#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// Compresses to a zlib stream with zlib itself, for systems without the faster libraries.
/// @param bytes  CV_8UC1, without gaps between rows
/// @param compression  0 and 1 zlib's first level, fastest; up to 9, smallest
/// @throws Error if memory runs out
[[nodiscard]] std::vector<uchar> zlibDeflated(const cv::Mat& bytes, int compression);

}  // namespace synthetic_dataset::base

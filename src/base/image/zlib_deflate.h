#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// A zlib stream by zlib itself, for systems on which the quicker libraries are missing.
/// @param bytes  CV_8UC1, without gaps between rows
/// @param compression  0 and 1 zlib's first level, fastest; up to 9, smallest
/// @throws Error when there is no memory for it
[[nodiscard]] std::vector<uchar> zlibDeflated(const cv::Mat& bytes, int compression);

}  // namespace synthetic_dataset::base

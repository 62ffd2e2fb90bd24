#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// Compresses to a zlib stream with ISA-L: in a quarter of libdeflate's time, a tenth larger.
/// @throws Error if ISA-L fails
[[nodiscard]] std::vector<uchar> isalDeflated(const cv::Mat& bytes);

}  // namespace synthetic_dataset::base

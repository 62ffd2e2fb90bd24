#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// Decodes the formats that OpenCV lacks.
/// @param name  the file's, whose ending names a format that has no magic number (TGA)
/// @return CV_8UC4: blue, green, red, alpha; of linear light CV_32FC3: red, green, blue; the first
///     row on top. Empty for what cannot be decoded
[[nodiscard]] cv::Mat decodeWithFreeImage(const std::vector<std::uint8_t>& file,
                                          const std::string& name);

}  // namespace synthetic_dataset::base

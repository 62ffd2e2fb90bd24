#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// Decodes the formats that OpenCV lacks.
/// @param name  the file's name, whose extension identifies a format without a magic number (TGA)
/// @return CV_8UC4: blue, green, red, alpha; for linear light CV_32FC3: red, green, blue; the first
///     row on top. Empty if the file cannot be decoded
[[nodiscard]] cv::Mat decodeWithFreeImage(const std::vector<std::uint8_t>& file,
                                          const std::string& name);

}  // namespace synthetic_dataset::base

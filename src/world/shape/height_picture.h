#pragma once

#include <filesystem>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::world {

/// The picture of a heightmap or a map of walls as numbers: CV_32FC3, red, green and blue from 0 to
/// 1, of 8 or 16 bits.
/// @throws Error "picture 'x.png': <why not>"
[[nodiscard]] cv::Mat readNumbers(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world

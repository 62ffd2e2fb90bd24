#pragma once

#include <filesystem>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::world {

/// The picture of a heightmap or wall map.
struct NumberPicture {
  cv::Mat numbers;             ///< CV_32FC3: red, green and blue from 0 to 1
  bool has_eight_bits = true;  ///< else 16
};

/// @throws Error "picture 'x.png': <why not>"
[[nodiscard]] NumberPicture readNumbers(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world

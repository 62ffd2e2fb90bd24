#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// Pixels as a camera's driver sends them, with the members of sensor_msgs/Image.
struct RawPicture {
  std::uint32_t width = 0;   ///< [px]
  std::uint32_t height = 0;  ///< [px]
  std::string encoding;      ///< of sensor_msgs/image_encodings.h
  bool is_bigendian = false;
  std::size_t step = 0;  ///< from a row's first byte to that of the next
  std::vector<std::uint8_t> data;
};

/// Why it cannot be read: an encoding that is not known, fewer bytes than its size needs; nothing
/// when it can.
[[nodiscard]] std::optional<std::string> pictureProblem(const RawPicture& picture);

/// The colours as CV_8UC3: blue, green, red. Grey values are taken three times, mosaics are
/// interpolated as cv_bridge and OpenCV do it (bilinear), of 16 bits the range 0 to 65535 becomes
/// 0 to 255, alpha is left out.
/// @throws Error with pictureProblem()
[[nodiscard]] cv::Mat coloursOf(const RawPicture& picture);

/// The same of what a picture's file was decoded to: grey, blue green red, or with alpha, of 8 or
/// 16 bits.
[[nodiscard]] cv::Mat coloursOf(const cv::Mat& decoded);

}  // namespace synthetic_dataset::base

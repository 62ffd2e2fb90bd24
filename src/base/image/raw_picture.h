#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

/// Pixels as sent by a camera driver, with the members of sensor_msgs/Image.
struct RawPicture {
  std::uint32_t width = 0;   ///< [px]
  std::uint32_t height = 0;  ///< [px]
  std::string encoding;      ///< of sensor_msgs/image_encodings.h
  bool is_bigendian = false;
  std::size_t step = 0;  ///< from one row's first byte to the next row's
  std::vector<std::uint8_t> data;
};

/// Why a picture cannot be read, such as an unknown encoding or fewer bytes than its size needs;
/// nullopt if it can.
[[nodiscard]] std::optional<std::string> pictureProblem(const RawPicture& picture);

/// The colours as CV_8UC3: blue, green, red. Grey values are repeated three times, Bayer mosaics
/// are interpolated as in cv_bridge and OpenCV (bilinear), 16-bit values are scaled from 0 to 65535
/// to 0 to 255, alpha is dropped.
/// @throws Error with pictureProblem()
[[nodiscard]] cv::Mat coloursOf(const RawPicture& picture);

/// The same for a decoded picture file: grey, blue green red, or blue green red alpha, of 8 or 16
/// bits.
[[nodiscard]] cv::Mat coloursOf(const cv::Mat& decoded);

}  // namespace synthetic_dataset::base

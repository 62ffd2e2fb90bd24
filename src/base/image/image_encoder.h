#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::base {

enum class ImageFormat { kPng, kJpeg, kTiff };

struct ImageQuality {
  int png_compression = 1;  ///< 0 and 1 fastest .. 9 smallest
  int jpeg_quality = 95;    ///< 1 .. 100
};

/// The format of a file name's extension, if any.
[[nodiscard]] std::optional<ImageFormat> imageFormat(const std::string& path);

/// Why an image cannot be written to a file of this name; nullopt if it can.
[[nodiscard]] std::optional<std::string> imageProblem(const std::string& path,
                                                      const cv::Mat& image);
[[nodiscard]] std::optional<std::string> imageProblem(const std::string& path, const Mask& mask);

/// Encodes an image, with the same bytes for the same pixels.
/// @throws Error if the image cannot be encoded
[[nodiscard]] std::vector<uchar> encodeImage(const cv::Mat& image, ImageFormat format,
                                             const ImageQuality& quality);

}  // namespace synthetic_dataset::base

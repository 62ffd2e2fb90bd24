#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

namespace synthetic_dataset::output {

/// Why an image of places in a table of colours cannot be written; nothing when it can.
[[nodiscard]] std::optional<std::string> indexedImageProblem(const std::string& path,
                                                             const cv::Mat& indices,
                                                             const std::vector<cv::Vec3b>& palette);

/// A PNG of colour type 3 (ISO/IEC 15948), 8 bits a pixel; OpenCV writes none. The same bytes for
/// the same pixels.
/// @param palette  blue, green, red
/// @param compression  0 fastest .. 9 smallest
/// @throws Error when libpng fails
[[nodiscard]] std::vector<uchar> encodeIndexedPng(const cv::Mat& indices,
                                                  const std::vector<cv::Vec3b>& palette,
                                                  int compression);

}  // namespace synthetic_dataset::output

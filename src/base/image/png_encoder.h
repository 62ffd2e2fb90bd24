#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

namespace synthetic_dataset::base {

/// Why an image of palette indices cannot be written; nullopt if it can.
[[nodiscard]] std::optional<std::string> indexedImageProblem(const std::string& path,
                                                             const cv::Mat& indices,
                                                             const std::vector<cv::Vec3b>& palette);

/// Encodes a PNG (ISO/IEC 15948), with the same bytes for the same pixels: deflated as described in
/// deflate.h, each row with whichever of three filters that can use SIMD instructions leaves the
/// smallest numbers. Masks (pixels of only 0 and 255) are not filtered, and are deflated as runs
/// whatever `compression` is.
/// @param image  CV_8UC1, CV_16UC1 or CV_8UC3 (blue, green, red)
/// @param palette  the colours (blue, green, red) if the image holds palette indices; else empty
/// @param compression  0 and 1 ISA-L, fastest; 2 .. 9 libdeflate, smallest
/// @throws Error as `deflated` does
[[nodiscard]] std::vector<uchar> encodePng(const cv::Mat& image,
                                           const std::vector<cv::Vec3b>& palette, int compression);

}  // namespace synthetic_dataset::base

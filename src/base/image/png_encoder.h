#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

namespace synthetic_dataset::base {

/// Why an image of places in a table of colours cannot be written; nothing when it can.
[[nodiscard]] std::optional<std::string> indexedImageProblem(const std::string& path,
                                                             const cv::Mat& indices,
                                                             const std::vector<cv::Vec3b>& palette);

/// A PNG (ISO/IEC 15948), the same bytes for the same pixels: deflated as
/// deflate.h says, and each row is filtered in the way, of three that processors do many bytes at a
/// time, that leaves the smallest numbers. Masks (pixels of 0 and 255 alone) are not filtered, and
/// deflated as runs, whatever `compression` is.
/// @param image  CV_8UC1, CV_16UC1 or CV_8UC3 (blue, green, red)
/// @param palette  the colours (blue, green, red) of an image of places in it; else empty
/// @param compression  0 and 1 ISA-L, fastest; 2 .. 9 libdeflate, smallest
/// @throws Error as `deflated` does
[[nodiscard]] std::vector<uchar> encodePng(const cv::Mat& image,
                                           const std::vector<cv::Vec3b>& palette, int compression);

}  // namespace synthetic_dataset::base

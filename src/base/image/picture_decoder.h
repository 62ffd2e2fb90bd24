#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/image/picture_size.h"

namespace synthetic_dataset::base {

/// The largest allowed picture, so that a file of a few bytes cannot fill the memory [pixel].
constexpr std::uint64_t kLongestPictureSide = 16384;
constexpr std::uint64_t kLargestPicture = std::uint64_t{1} << 27U;

/// Decodes a picture file of any format that OpenCV or FreeImage knows: PNG, JPEG, BMP, TIFF, WebP,
/// TGA, GIF (its first picture), DDS, PSD, PGM and more; of any depth; grey, with a palette, with
/// alpha. The size is checked before anything is decoded, and a decoder that crashes does not take
/// this process down.
/// @param name  the file's name, whose extension identifies formats without a magic number
/// @return in the file's own format: grey, blue green red, or blue green red alpha, of 8 or 16 bits
/// @throws Error "cannot be decoded; ...", "is too large: ...", "holds linear light ..."
[[nodiscard]] cv::Mat decodePixels(const std::vector<std::uint8_t>& file, const std::string& name);

/// Checks, without decoding, that decodePictureOrLight can be expected to read a picture: that its
/// header is valid and, as far as its format tells, that the file is not truncated. Files whose
/// header gives no size are decoded after all.
/// @return its size
/// @throws Error as decodePictureOrLight does
PictureSize checkPicture(const std::vector<std::uint8_t>& file, const std::string& name);

/// As decodePixels, but CV_8UC4: blue, green, red, alpha.
[[nodiscard]] cv::Mat decodePicture(const std::vector<std::uint8_t>& file, const std::string& name);

/// As decodePicture, but also decodes pictures of linear light (Radiance and OpenEXR), which may be
/// brighter than white.
/// @return for linear light CV_32FC4: blue, green, red, alpha; opaque, 0 .. 65504, 1 for white
[[nodiscard]] cv::Mat decodePictureOrLight(const std::vector<std::uint8_t>& file,
                                           const std::string& name);

/// decodePicture() for many files, some of them in parallel.
/// @param files  by name
/// @return by name, the pictures that could be decoded and whose header gives a size; for the
///     others, decodePicture reports what is wrong
[[nodiscard]] std::map<std::string, cv::Mat> decodePictures(
    const std::map<std::string, std::vector<std::uint8_t>>& files);

}  // namespace synthetic_dataset::base

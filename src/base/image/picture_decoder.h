#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/image/picture_size.h"

namespace synthetic_dataset::base {

/// What a picture may have at most, so that a file of a few bytes cannot fill the memory [pixel].
constexpr std::uint64_t kLongestPictureSide = 16384;
constexpr std::uint64_t kLargestPicture = std::uint64_t{1} << 27U;

/// Decodes a picture file of any format that OpenCV or FreeImage knows: PNG, JPEG, BMP, TIFF, WebP,
/// TGA, GIF (its first picture), DDS, PSD, PGM and more; of any depth; grey, with a palette, with
/// alpha. The size is checked before anything is decoded, and a decoder that crashes takes nothing
/// with it.
/// @param name  the file's, whose ending names formats that have no magic number
/// @return as the file has it: grey, blue green red, or blue green red alpha, of 8 or 16 bits
/// @throws Error "cannot be decoded; ...", "is too large: ...", "holds linear light ..."
[[nodiscard]] cv::Mat decodePixels(const std::vector<std::uint8_t>& file, const std::string& name);

/// Whether decodePixels may be expected to read it, without decoding it: what its header says, and
/// that the file does not break off, as far as its format says. Files of formats whose headers are
/// not known here are decoded after all. Pictures of linear light pass, too.
/// @return its size
/// @throws Error as decodePictureOrLight does
PictureSize checkPicture(const std::vector<std::uint8_t>& file, const std::string& name);

/// decodePixels as CV_8UC4: blue, green, red, alpha.
[[nodiscard]] cv::Mat decodePicture(const std::vector<std::uint8_t>& file, const std::string& name);

/// decodePicture, and also pictures of linear light, which may be brighter than white: Radiance's
/// and OpenEXR's.
/// @return of these CV_32FC4: blue, green, red, alpha; opaque, 0 .. 65504, 1 for white
[[nodiscard]] cv::Mat decodePictureOrLight(const std::vector<std::uint8_t>& file,
                                           const std::string& name);

/// decodePicture of many files, some of them side by side.
/// @param files  by their names
/// @return those that could be decoded, by their names, without those whose header gives no size;
/// of
///     the others decodePicture says what is wrong
[[nodiscard]] std::map<std::string, cv::Mat> decodePictures(
    const std::map<std::string, std::vector<std::uint8_t>>& files);

}  // namespace synthetic_dataset::base

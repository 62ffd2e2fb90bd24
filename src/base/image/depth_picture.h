#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/image/picture_size.h"
#include "base/image/raw_picture.h"

namespace synthetic_dataset::base {

/// Why a picture cannot be read as depth (REP 118): it should be 32FC1 in metres, or 16UC1 (mono16)
/// in millimetres. nullopt if it can.
[[nodiscard]] std::optional<std::string> depthProblem(const RawPicture& picture);

/// The picture as CV_32FC1: z of the visible surface [m]; 0 where nothing was measured.
/// @throws Error with depthProblem()
[[nodiscard]] cv::Mat depthOf(const RawPicture& picture);

/// The size of a picture written by compressed_depth_image_transport, without decoding it.
/// @param format  of the message: "16UC1; compressedDepth png"
/// @throws Error saying why it cannot be read
[[nodiscard]] PictureSize checkCompressedDepth(const std::vector<std::uint8_t>& file,
                                               const std::string& format);

/// depthOf() for a picture written by compressed_depth_image_transport.
/// @throws Error as checkCompressedDepth
[[nodiscard]] cv::Mat depthOfCompressed(const std::vector<std::uint8_t>& file,
                                        const std::string& format);

}  // namespace synthetic_dataset::base

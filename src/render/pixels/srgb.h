#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// sRGB's transfer function (IEC 61966-2-1): the linear light of an encoded value, both 0 .. 1.
[[nodiscard]] float linearFromSrgb(float encoded);

/// The linear light of each 8-bit encoded value.
[[nodiscard]] const std::array<float, 256>& linearFromSrgb();

/// The nearest sRGB-encoded value of linear light, which is clipped to 0 .. 1.
[[nodiscard]] std::uint8_t srgbFromLinear(float linear);

/// Linear light from sRGB-encoded red, green and blue.
[[nodiscard]] Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded);

/// The same with alpha as the last, which is linear in both.
[[nodiscard]] Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded);

/// Encodes linear light; values above 1 become 1, negative ones 0.
/// @param light  CV_16UC4: red, green, blue, alpha as half floats (IEEE 754 binary16)
/// @param wanted  CV_8UC1 of the same size: not 0 for the pixels to encode
/// @param picture  CV_8UC3 of the same size: blue, green and red; its other pixels are not changed
void encodeSrgb(const cv::Mat& light, const cv::Mat& wanted, cv::Mat& picture);

}  // namespace synthetic_dataset::render

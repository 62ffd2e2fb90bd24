#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// sRGB's transfer function (IEC 61966-2-1): the light of an encoded value, both 0 .. 1.
[[nodiscard]] float linearFromSrgb(float encoded);

/// The light of each encoded value of 8 bits.
[[nodiscard]] const std::array<float, 256>& linearFromSrgb();

/// The nearest sRGB-encoded value of a light; beyond 0 .. 1 it is clipped.
[[nodiscard]] std::uint8_t srgbFromLinear(float linear);

/// Linear light from sRGB-encoded red, green and blue.
[[nodiscard]] Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded);

/// Alpha, the last, is linear in either.
[[nodiscard]] Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded);

/// Encodes linear light; what is brighter than 1 is white, what is negative black.
/// @param light  CV_16UC4: red, green, blue, alpha as numbers of 16 bits (IEEE 754 binary16)
/// @param wanted  CV_8UC1 of the same size: not 0 for the pixels that are encoded
/// @param picture  CV_8UC3 of the same size: blue, green and red; its other pixels stay
void encodeSrgb(const cv::Mat& light, const cv::Mat& wanted, cv::Mat& picture);

}  // namespace synthetic_dataset::render

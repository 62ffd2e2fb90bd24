#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace synthetic_dataset::test {

/// The 16-bit float that OpenCV rounds a number to, as bits. From OpenCV 4.10 on, its type for such
/// numbers has another name and no access to the bits.
[[nodiscard]] inline std::uint16_t halfBits(float number) {
  cv::Mat half;
  cv::Mat(1, 1, CV_32F, cv::Scalar(number)).convertTo(half, CV_16F);
  return *half.ptr<std::uint16_t>();
}

/// The number that OpenCV reads from the bits of a 16-bit float.
[[nodiscard]] inline float halfNumber(std::uint16_t bits) {
  cv::Mat number;
  cv::Mat(1, 1, CV_16F, &bits).convertTo(number, CV_32F);
  return *number.ptr<float>();
}

}  // namespace synthetic_dataset::test

#include "render/pixels/encoded_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "render/pixels/half.h"
#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

constexpr float kMost = 16.0F;
constexpr std::size_t kMostBits = 0x4C00;  // kMost as a half float

/// sRGB's transfer function (IEC 61966-2-1), continued beyond 1.
float decoded(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

float encodedOf(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

/// The linear light of each half float from 0 to kMost, whose bits are 0 to kMostBits.
const std::array<float, kMostBits + 1>& lightOfNumbers() {
  static const auto kLight = [] {
    std::array<float, kMostBits + 1> light{};
    for (std::size_t bits = 0; bits < light.size(); ++bits) {
      light[bits] = decoded(fromHalf(static_cast<std::uint16_t>(bits)));
    }
    return light;
  }();
  return kLight;
}

/// The half float that each half float becomes. Negative ones, infinity and NaN become 0.
std::vector<std::uint16_t> tableFor(float exposure) {
  const auto& light = lightOfNumbers();
  std::vector<std::uint16_t> table(0x10000, 0);
  for (std::size_t bits = 0; bits < light.size(); bits += kLaneCount) {
    std::array<float, kLaneCount> four{};
    for (std::size_t i = 0; i < four.size(); ++i) {
      four[i] = std::min(exposure * light[std::min(bits + i, kMostBits)], 1.0F);
    }
    std::array<std::uint32_t, kLaneCount> halves{};
    cv::v_store(halves.data(), halfFrom(cv::v_load(four.data())));
    for (std::size_t i = 0; i < halves.size(); ++i) {
      table[bits + i] = static_cast<std::uint16_t>(halves[i]);
    }
  }
  const auto infinite = table.begin() + 0x7C00;
  std::fill(table.begin() + kMostBits, infinite, table[kMostBits]);
  return table;
}

}  // namespace

float brightestEncoded(float exposure) {
  return exposure < 1.0F ? std::min(encodedOf(1.0F / std::max(exposure, 1e-6F)), kMost) : 1.0F;
}

void exposeEncoded(cv::Mat& light, float exposure, const std::vector<cv::Rect>& regions) {
  const std::vector<std::uint16_t> table = tableFor(exposure);
  for (const cv::Rect& region : regions) {
    for (int v = region.y; v < region.y + region.height; ++v) {
      auto* pixel = light.ptr<cv::Vec4w>(v, region.x);
      for (int u = 0; u < region.width; ++u, ++pixel) {
        for (int c = 0; c < 3; ++c) (*pixel)[c] = table[(*pixel)[c]];
      }
    }
  }
}

}  // namespace synthetic_dataset::render

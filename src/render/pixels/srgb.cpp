#include "render/pixels/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/pixels/half.h"

namespace synthetic_dataset::render {
namespace {

std::array<float, 256> makeTable(float offset) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = linearFromSrgb((static_cast<float>(i) + offset) / 255.0F);
  }
  return table;
}

/// Where to begin the search for an encoded value: the lowest one of each small range of light.
struct Encoder {
  static constexpr std::size_t kRanges = 4096;

  Encoder() {
    std::uint8_t value = 0;
    for (std::size_t i = 0; i < kRanges; ++i) {
      const float light = static_cast<float>(i) / kRanges;
      while (value < 255 && light >= upper[value]) ++value;
      first[i] = value;
    }
  }

  std::array<float, 256> upper = makeTable(0.5F);  ///< light above which the next value is nearer
  std::array<std::uint8_t, kRanges> first{};
};

/// The encoded value of each half float from 0 to 1.
class HalfEncoder {
 public:
  HalfEncoder() {
    for (std::size_t bits = 0; bits < table_.size(); ++bits) {
      table_[bits] = render::srgbFromLinear(fromHalf(static_cast<std::uint16_t>(bits)));
    }
  }

  [[nodiscard]] std::uint8_t operator()(std::uint16_t bits) const {
    constexpr std::uint16_t kNegative = 0x8000;
    return (bits & kNegative) != 0 ? 0 : table_[std::min<std::size_t>(bits, kOne)];
  }

 private:
  static constexpr std::size_t kOne = 0x3C00;
  std::array<std::uint8_t, kOne + 1> table_{};
};

}  // namespace

float linearFromSrgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

const std::array<float, 256>& linearFromSrgb() {
  static const std::array<float, 256> kTable = makeTable(0.0F);
  return kTable;
}

std::uint8_t srgbFromLinear(float linear) {
  static const Encoder kEncoder;
  if (!(linear > 0.0F)) return 0;
  if (linear >= 1.0F) return 255;
  std::uint8_t value =
      kEncoder.first[static_cast<std::size_t>(linear * static_cast<float>(Encoder::kRanges))];
  while (value < 255 && linear >= kEncoder.upper[value]) ++value;
  return value;
}

Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded) {
  return encoded.unaryExpr([](float channel) { return render::linearFromSrgb(channel); });
}

Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded) {
  const Eigen::Vector3f colour = linearFromSrgb(Eigen::Vector3f(encoded.head<3>()));
  return {colour.x(), colour.y(), colour.z(), encoded.w()};
}

void encodeSrgb(const cv::Mat& light, const cv::Mat& wanted, cv::Mat& picture) {
  static const HalfEncoder kEncoder;
  for (int v = 0; v < light.rows; ++v) {
    const auto* from = light.ptr<std::uint16_t>(v);
    const auto* is_wanted = wanted.ptr<std::uint8_t>(v);
    auto* to = picture.ptr<std::uint8_t>(v);
    for (int u = 0; u < light.cols; ++u, from += 4, to += 3) {
      if (is_wanted[u] == 0) continue;
      to[0] = kEncoder(from[2]);
      to[1] = kEncoder(from[1]);
      to[2] = kEncoder(from[0]);
    }
  }
}

}  // namespace synthetic_dataset::render

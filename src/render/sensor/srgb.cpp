#include "render/sensor/srgb.h"

#include <cmath>
#include <cstddef>

namespace synthetic_dataset::render {
namespace {

std::array<float, 256> makeTable(float offset) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = linearFromSrgb((static_cast<float>(i) + offset) / 255.0F);
  }
  return table;
}

/// Where to begin looking for an encoded value: the least one of each small range of light.
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

  std::array<float, 256> upper = makeTable(0.5F);  ///< where the next encoded value is nearer
  std::array<std::uint8_t, kRanges> first{};
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

}  // namespace synthetic_dataset::render

#pragma once

#include <cstdint>
#include <cstring>

#include <opencv2/core/mat.hpp>

#include "randomize/appearance/natural/natural_colour.h"

/// A pixel's channels packed into one integer, 16 bits each, so that one operation handles all.
namespace synthetic_dataset::randomize::natural {

using Lanes = std::uint64_t;

constexpr Lanes kEachLane = 0x0001000100010001ULL;

[[nodiscard]] inline Lanes lanesOf(const cv::Vec4b& pixel) {
  std::uint32_t packed = 0;
  std::memcpy(&packed, pixel.val, sizeof packed);
  Lanes lanes = packed;
  lanes = (lanes | lanes << 16U) & 0x0000FFFF0000FFFFULL;
  return (lanes | lanes << 8U) & (kEachLane * 0xFFU);
}

[[nodiscard]] inline Lanes lanesOf(const Colour& colour) { return lanesOf(pixelOf(colour)); }

/// @param lanes  0 .. 255 each
inline void setPixel(cv::Vec4b& pixel, Lanes lanes) {
  lanes = (lanes | lanes >> 8U) & 0x0000FFFF0000FFFFULL;
  const auto packed = static_cast<std::uint32_t>(lanes | lanes >> 16U);
  std::memcpy(pixel.val, &packed, sizeof packed);
}

/// Opaque alpha: last in memory, so the highest lane, since this only runs on little-endian
/// machines.
constexpr Lanes kOpaqueLane = 0xFFULL << 48U;

/// Multiplies by a light; whatever becomes too bright is clamped to white.
/// @param light  256 leaves the lanes unchanged; limited to 0 .. 510
[[nodiscard]] inline Lanes litLanes(Lanes lanes, int light) {
  const int bounded = light < 0 ? 0 : (light > 510 ? 510 : light);
  const Lanes product = (lanes * static_cast<Lanes>(bounded / 2)) >> 7U & (kEachLane * 0x1FFU);
  const Lanes over = product & (kEachLane * 0x100U);
  return (product | (over - (over >> 8U))) & (kEachLane * 0xFFU);
}

/// @param share  of the second pixel, 0 .. 256
[[nodiscard]] inline Lanes mixedLanes(Lanes first, Lanes second, int share) {
  const auto part = static_cast<Lanes>(share);
  return (first * (256U - part) + second * part) >> 8U & (kEachLane * 0xFFU);
}

}  // namespace synthetic_dataset::randomize::natural

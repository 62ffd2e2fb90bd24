#pragma once

#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "base/random/random_source.h"

namespace synthetic_dataset::randomize::natural {

/// sRGB-encoded components, 0 .. 255 each.
struct Colour {
  int blue = 0;
  int green = 0;
  int red = 0;
};

/// Typical colours of things: most are dull, between brown, grey, green and blue; few are vivid.
enum class Hues { kGrey, kEarth, kDry, kGreen, kSky, kBrick, kCream, kDark, kVivid };

[[nodiscard]] Colour drawColour(base::RandomSource& random, Hues hues);

/// Draws from all hues, each as often as it occurs.
[[nodiscard]] Colour drawAnyColour(base::RandomSource& random);

/// @param share  of the second colour, 0 .. 256
[[nodiscard]] Colour mixed(const Colour& first, const Colour& second, int share);

/// @param light  256 leaves the colour unchanged
[[nodiscard]] Colour lit(const Colour& colour, int light);

[[nodiscard]] inline std::uint8_t byteOf(int value) {
  return static_cast<std::uint8_t>(value < 0 ? 0 : (value > 255 ? 255 : value));
}

[[nodiscard]] inline cv::Vec4b pixelOf(const Colour& colour) {
  return {byteOf(colour.blue), byteOf(colour.green), byteOf(colour.red), 255};
}

/// A surface's colours, by its tones.
using Palette = std::array<cv::Vec4b, 256>;

/// Fills the tones from `first` to `last` (at most 255) with a gradient between two colours.
void addRamp(Palette& palette, int first, int last, const Colour& from, const Colour& to);

/// Fills the tones from `first` to `last` with shades of a colour, which itself is in the middle.
void addShades(Palette& palette, int first, int last, const Colour& colour, int contrast);

}  // namespace synthetic_dataset::randomize::natural

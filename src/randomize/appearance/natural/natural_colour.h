#pragma once

#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "base/random/random_source.h"

namespace synthetic_dataset::randomize::natural {

/// sRGB-encoded, each 0 .. 255.
struct Colour {
  int blue = 0;
  int green = 0;
  int red = 0;
};

/// Where colours of things lie: most are dull, between brown, grey, green and blue; few are vivid.
enum class Hues { kGrey, kEarth, kDry, kGreen, kSky, kBrick, kCream, kDark, kVivid };

[[nodiscard]] Colour drawColour(base::RandomSource& random, Hues hues);

/// Of any of the hues, each as often as it is met with.
[[nodiscard]] Colour drawAnyColour(base::RandomSource& random);

/// @param share  of the second, 0 .. 256
[[nodiscard]] Colour mixed(const Colour& first, const Colour& second, int share);

/// @param light  256: as it is
[[nodiscard]] Colour lit(const Colour& colour, int light);

[[nodiscard]] inline std::uint8_t byteOf(int value) {
  return static_cast<std::uint8_t>(value < 0 ? 0 : (value > 255 ? 255 : value));
}

[[nodiscard]] inline cv::Vec4b pixelOf(const Colour& colour) {
  return {byteOf(colour.blue), byteOf(colour.green), byteOf(colour.red), 255};
}

/// A surface's colours, by its tones.
using Palette = std::array<cv::Vec4b, 256>;

/// From one colour to another over the tones from `first` to `last`, at most 255.
void addRamp(Palette& palette, int first, int last, const Colour& from, const Colour& to);

/// A colour's shades over the tones from `first` to `last`: the colour itself in their middle.
void addShades(Palette& palette, int first, int last, const Colour& colour, int contrast);

}  // namespace synthetic_dataset::randomize::natural

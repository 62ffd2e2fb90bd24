#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "base/random/random_source.h"
#include "randomize/appearance/natural/natural_colour.h"
#include "randomize/appearance/natural/noise_table.h"

namespace synthetic_dataset::randomize::natural {

/// A square of pixels that repeats; the side is a power of two.
struct Tile {
  /// Makes all levels from the finest one: each is the mean of two by two pixels.
  Tile(int bits, std::vector<cv::Vec4b> pixels);

  /// Makes a tile of a single colour.
  explicit Tile(const Colour& colour) : Tile(0, {pixelOf(colour)}) {}

  int bits;                                    ///< log2 of the finest level's side
  std::vector<std::vector<cv::Vec4b>> levels;  ///< each half as wide as the previous one
};

/// A surface that repeats, before it is lit.
struct Surface {
  /// @param side_bits  log2 of the side: 7 to 9
  explicit Surface(int side_bits)
      : bits(side_bits),
        side(1 << side_bits),
        tone(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)),
        height(tone.size()) {}

  /// Wraps around at the borders.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(((y & (side - 1)) << bits) | (x & (side - 1)));
  }

  /// The number of noise places per pixel, so that the noise repeats together with the surface.
  [[nodiscard]] int noiseStep() const { return NoiseTable::kSide >> bits; }

  int bits;
  int side;
  std::vector<std::uint8_t> tone;    ///< index in the palette
  std::vector<std::uint8_t> height;  ///< above the ground
  Palette palette{};
  int bump = 16;    ///< how visible slopes are
  int stains = 20;  ///< variation in brightness from place to place
};

/// Clamps a number to the range of a tone or a height.
[[nodiscard]] inline std::uint8_t asByte(int number) {
  return static_cast<std::uint8_t>(std::clamp(number, 0, 255));
}

/// Calls `set(x, y, tone, height)` for each pixel, with references to its tone and height.
template <typename Set>
void forEachPixel(Surface& surface, const Set& set) {
  for (int y = 0; y < surface.side; ++y) {
    for (int x = 0; x < surface.side; ++x) {
      const std::size_t i = surface.index(x, y);
      set(x, y, surface.tone[i], surface.height[i]);
    }
  }
}

/// Noise indexed by a surface's pixels, repeating together with it.
class SurfaceNoise {
 public:
  SurfaceNoise(const Surface& surface, Waves waves)
      : table_(noise(waves)), step_(surface.noiseStep()) {}

  /// @param further_x, further_y  an offset, in places of the noise
  [[nodiscard]] int at(int x, int y, int further_x = 0, int further_y = 0) const {
    return table_.at(x * step_ + further_x, y * step_ + further_y);
  }

 private:
  const NoiseTable& table_;
  int step_;
};

/// The pixels of a surface: lit from one side, and stained.
[[nodiscard]] std::vector<cv::Vec4b> litPixels(const Surface& surface, base::RandomSource& random);

}  // namespace synthetic_dataset::randomize::natural

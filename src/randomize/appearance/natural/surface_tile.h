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

/// A square of pixels that repeats; its side is a power of two.
struct Tile {
  /// Of a finest level: the others are means of two by two.
  Tile(int bits, std::vector<cv::Vec4b> pixels);

  /// Of one colour.
  explicit Tile(const Colour& colour) : Tile(0, {pixelOf(colour)}) {}

  int bits;                                    ///< of the finest level's side
  std::vector<std::vector<cv::Vec4b>> levels;  ///< each half as wide as the one before
};

/// A surface that repeats, before it is lit.
struct Surface {
  /// @param side_bits  of its side: 7 to 9
  explicit Surface(int side_bits)
      : bits(side_bits),
        side(1 << side_bits),
        tone(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)),
        height(tone.size()) {}

  /// Beyond the border is the other side.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(((y & (side - 1)) << bits) | (x & (side - 1)));
  }

  /// By how many places the noise goes on with a pixel, so that it repeats as the surface does.
  [[nodiscard]] int noiseStep() const { return NoiseTable::kSide >> bits; }

  int bits;
  int side;
  std::vector<std::uint8_t> tone;    ///< which colour of the palette
  std::vector<std::uint8_t> height;  ///< over the ground
  Palette palette{};
  int bump = 16;    ///< how much slopes are seen
  int stains = 20;  ///< how much it is lighter and darker from place to place
};

/// A number as a tone or a height: the nearest that there is.
[[nodiscard]] inline std::uint8_t asByte(int number) {
  return static_cast<std::uint8_t>(std::clamp(number, 0, 255));
}

/// Calls `set(x, y, tone, height)` with references to the latter two of each pixel.
template <typename Set>
void forEachPixel(Surface& surface, const Set& set) {
  for (int y = 0; y < surface.side; ++y) {
    for (int x = 0; x < surface.side; ++x) {
      const std::size_t i = surface.index(x, y);
      set(x, y, surface.tone[i], surface.height[i]);
    }
  }
}

/// Noise by a surface's pixels, which repeats as that does.
class SurfaceNoise {
 public:
  SurfaceNoise(const Surface& surface, Waves waves)
      : table_(noise(waves)), step_(surface.noiseStep()) {}

  /// @param further_x, further_y  by how many places of the noise
  [[nodiscard]] int at(int x, int y, int further_x = 0, int further_y = 0) const {
    return table_.at(x * step_ + further_x, y * step_ + further_y);
  }

 private:
  const NoiseTable& table_;
  int step_;
};

/// A surface's pixels: lit from a side, and stained.
[[nodiscard]] std::vector<cv::Vec4b> litPixels(const Surface& surface, base::RandomSource& random);

}  // namespace synthetic_dataset::randomize::natural

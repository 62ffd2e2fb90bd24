#include "randomize/appearance/natural/surface_tile.h"

#include <algorithm>
#include <array>
#include <utility>

#include "randomize/appearance/natural/pixel_lanes.h"
#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {
namespace {

std::vector<cv::Vec4b> halved(const std::vector<cv::Vec4b>& pixels, int bits) {
  const std::size_t side = std::size_t{1} << static_cast<unsigned>(bits);
  std::vector<cv::Vec4b> half;
  half.reserve(pixels.size() / 4);
  for (std::size_t y = 0; y < side; y += 2) {
    for (std::size_t x = 0; x < side; x += 2) {
      const cv::Vec4b* first = &pixels[y * side + x];
      cv::Vec4b mean;
      for (int i = 0; i < 4; ++i) {
        mean[i] = static_cast<std::uint8_t>(
            (first[0][i] + first[1][i] + first[side][i] + first[side + 1][i] + 2) / 4);
      }
      half.push_back(mean);
    }
  }
  return half;
}

}  // namespace

Tile::Tile(int side_bits, std::vector<cv::Vec4b> pixels) : bits(side_bits) {
  levels.push_back(std::move(pixels));
  for (int level = bits; level > 0; --level) levels.push_back(halved(levels.back(), level));
}

std::vector<cv::Vec4b> litPixels(const Surface& surface, base::RandomSource& random) {
  constexpr std::array<std::array<int, 2>, 6> kLights = {
      {{3, 2}, {-3, 2}, {1, 4}, {-1, 4}, {4, 1}, {-2, -3}}};
  const std::array<int, 2>& from = kLights[static_cast<std::size_t>(below(random, 6))];
  const int across = from[0] * surface.bump;
  const int along = from[1] * surface.bump;
  const int shift_x = below(random, NoiseTable::kSide);
  const int shift_y = below(random, NoiseTable::kSide);
  const NoiseTable& stains = noise(Waves::kBroad);
  const NoiseTable& grain = noise(Waves::kGrain);
  const int step = surface.noiseStep();
  std::array<Lanes, 256> palette{};
  for (std::size_t tone = 0; tone < palette.size(); ++tone) {
    palette[tone] = lanesOf(surface.palette[tone]);
  }
  std::vector<cv::Vec4b> pixels(surface.tone.size());
  for (int y = 0; y < surface.side; ++y) {
    const std::uint8_t* above = &surface.height[surface.index(0, y - 1)];
    const std::uint8_t* here = &surface.height[surface.index(0, y)];
    const std::uint8_t* under = &surface.height[surface.index(0, y + 1)];
    const std::size_t row = surface.index(0, y);
    for (int x = 0; x < surface.side; ++x) {
      const int before = here[(x - 1) & (surface.side - 1)];
      const int behind = here[(x + 1) & (surface.side - 1)];
      const int slope = (behind - before) * across + (under[x] - above[x]) * along;
      const int place_x = x * step + shift_x;
      const int place_y = y * step + shift_y;
      const int light = 256 + (slope >> 6) + (stains.at(place_x, place_y) * surface.stains >> 6) +
                        (grain.at(place_x, place_y) >> 3);
      const std::size_t i = row + static_cast<std::size_t>(x);
      setPixel(pixels[i], litLanes(palette[surface.tone[i]], light) | kOpaqueLane);
    }
  }
  return pixels;
}

}  // namespace synthetic_dataset::randomize::natural

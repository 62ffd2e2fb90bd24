#pragma once

#include <cstddef>

#include "randomize/appearance/natural/canvas.h"
#include "randomize/appearance/natural/pixel_lanes.h"

namespace synthetic_dataset::randomize::natural {

/// Reads texels of one level of a tile.
class TileReader {
 public:
  TileReader(const Tile& tile, int level)
      : pixels_(tile.levels[static_cast<std::size_t>(level)].data()),
        shift_(16U + static_cast<unsigned>(level)),
        bits_(static_cast<unsigned>(tile.bits - level)),
        mask_((1U << bits_) - 1U) {}

  [[nodiscard]] const cv::Vec4b& at(std::uint32_t u, std::uint32_t v) const {
    return pixels_[(((v >> shift_) & mask_) << bits_) | ((u >> shift_) & mask_)];
  }

 private:
  const cv::Vec4b* pixels_;
  unsigned shift_;
  unsigned bits_;
  std::uint32_t mask_;
};

/// The mipmap level to use when this many of a tile's pixels fall on each canvas pixel.
[[nodiscard]] inline int levelOf(const Tile& tile, double scale) {
  int level = 0;
  for (double rest = scale; rest > 1.5 && level < tile.bits; rest *= 0.5) ++level;
  return level;
}

/// Paints pixels of a row.
class RowPainter {
 public:
  explicit RowPainter(const Paint& paint)
      : paint_(paint),
        haze_(lanesOf(paint.haze)),
        reader_(paint.tile == nullptr ? nothing() : *paint.tile, paint.level) {}

  void startRow(int y) {
    const auto row = static_cast<std::uint32_t>(y);
    u_ = paint_.u + row * paint_.u_y;
    v_ = paint_.v + row * paint_.v_y;
    light_ = paint_.light + ((y - paint_.middle_y) * paint_.light_y >> 8);
  }

  [[nodiscard]] int lightAt(int x) const {
    return light_ + ((x - paint_.middle_x) * paint_.light_x >> 8);
  }

  /// @param coverage  of the pixel, 0 .. 256
  void put(cv::Vec4b& pixel, int x, int light, int coverage) const {
    const auto column = static_cast<std::uint32_t>(x);
    const cv::Vec4b& texel = paint_.tile == nullptr
                                 ? pixel
                                 : reader_.at(u_ + column * paint_.u_x, v_ + column * paint_.v_x);
    Lanes lanes = litLanes(lanesOf(texel), light);
    if (paint_.haze_share > 0) lanes = mixedLanes(lanes, haze_, paint_.haze_share);
    if (coverage < 256) lanes = mixedLanes(lanesOf(pixel), lanes, coverage);
    setPixel(pixel, lanes);
  }

  /// Paints the pixels from `first` to `last`, both on the canvas.
  void putSpan(cv::Vec4b* row, int first, int last) const {
    if (paint_.round == 0 && paint_.tile != nullptr) {
      putFlat(row, first, last);
      return;
    }
    if (paint_.round == 0) {
      for (int x = first; x <= last; ++x) put(row[x], x, lightAt(x), 256);
      return;
    }
    const int width = std::max(1, last - first + 1);
    for (int x = first; x <= last; ++x) {
      const int place = (2 * (x - first) + 1) * 256 / width - 256;  // -256 .. 256
      const int shade = 256 - ((place * place >> 8) * paint_.round >> 8);
      put(row[x], x, lightAt(x) * shade >> 8, 256);
    }
  }

 private:
  /// Fast path for most spans, which show a tile: no checks for each pixel.
  void putFlat(cv::Vec4b* row, int first, int last) const {
    const auto column = static_cast<std::uint32_t>(first);
    std::uint32_t u = u_ + column * paint_.u_x;
    std::uint32_t v = v_ + column * paint_.v_x;
    int light = 256 * light_ + (first - paint_.middle_x) * paint_.light_x;
    for (int x = first; x <= last; ++x) {
      Lanes lanes = litLanes(lanesOf(reader_.at(u, v)), light >> 8);
      if (paint_.haze_share > 0) lanes = mixedLanes(lanes, haze_, paint_.haze_share);
      setPixel(row[x], lanes);
      u += paint_.u_x;
      v += paint_.v_x;
      light += paint_.light_x;
    }
  }

  static const Tile& nothing() {
    static const Tile kNothing{Colour{}};
    return kNothing;
  }

  const Paint& paint_;
  Lanes haze_;
  TileReader reader_;
  std::uint32_t u_ = 0;
  std::uint32_t v_ = 0;
  int light_ = 256;
};

}  // namespace synthetic_dataset::randomize::natural

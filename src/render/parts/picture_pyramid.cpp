#include "render/parts/picture_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "render/pixels/mipmaps.h"

namespace synthetic_dataset::render {
namespace {

/// Like std::floor(), for which not all processors have an instruction.
/// @param numbers  from -2^31 up to 2^31
Lanes floorOf(const Lanes& numbers) {
  const Lanes nearer_to_0 = cv::v_cvt_f32(cv::v_trunc(numbers));
  return nearer_to_0 - (lanes(1.0F) & (nearer_to_0 > numbers));
}

/// The fractional parts; 0 for numbers so large that they are integers.
Lanes fractionOf(const Lanes& numbers) {
  const Lanes small = numbers & (cv::v_abs(numbers) < lanes(0x1p23F));
  return small - floorOf(small);
}

/// Blue, green, red and alpha of a texel.
Lanes texelAt(const std::uint16_t* row, int column) {
  return cv::v_cvt_f32(
      cv::v_reinterpret_as_s32(cv::v_load_expand(row + std::ptrdiff_t{4} * column)));
}

/// The texels before and after each of four places along a side of a picture that repeats beyond
/// its edges.
struct TexelsBeside {
  /// @param fractions  the places, from 0 to 1, as shares of the side's length
  TexelsBeside(const Lanes& fractions, int length) {
    const Lanes places = fractions * lanes(static_cast<float>(length)) - lanes(0.5F);
    const Lanes first = floorOf(places);  // -1 or more
    const cv::v_int32x4 end = cv::v_setall_s32(length);
    const cv::v_int32x4 zero = cv::v_setzero_s32();
    const cv::v_int32x4 from = cv::v_trunc(first);
    const cv::v_int32x4 next = from + cv::v_setall_s32(1);
    cv::v_store(before.data(), from + (end & (from < zero)));
    cv::v_store(after.data(), next & (next < end));
    cv::v_store(share.data(), places - first);
  }

  std::array<int, kLaneCount> before{}, after{};
  std::array<float, kLaneCount> share{};  ///< of the texel after
};

/// Four places on a level of a pyramid.
class PlacesOnLevel {
 public:
  PlacesOnLevel(const Lanes& x, const Lanes& y, const cv::Mat& level)
      : level_(level), columns_(x, level.cols), rows_(y, level.rows) {}

  /// The colour interpolated between the four texels around a place.
  [[nodiscard]] Lanes mixedAt(std::size_t place) const {
    const auto* above = level_.ptr<std::uint16_t>(rows_.before[place]);
    const auto* below = level_.ptr<std::uint16_t>(rows_.after[place]);
    const int u = columns_.before[place];
    const int next_u = columns_.after[place];
    const Lanes share = lanes(columns_.share[place]);
    return mix(mix(texelAt(above, u), texelAt(above, next_u), share),
               mix(texelAt(below, u), texelAt(below, next_u), share), lanes(rows_.share[place]));
  }

 private:
  const cv::Mat& level_;
  TexelsBeside columns_, rows_;
};

Eigen::Vector4f colourOf(const Lanes& sum, float count) {
  constexpr float kFull = 65535.0F;
  std::array<float, kLaneCount> bgra;
  cv::v_store(bgra.data(), sum * lanes(1.0F / (kFull * count)));
  return {bgra[2], bgra[1], bgra[0], bgra[3]};
}

constexpr std::size_t kMostTaps = 4;  // along a side of a pixel

/// Where a pixel's texture is looked up: relative to its middle, in units of the pixel's steps, row
/// by row.
struct Taps {
  std::array<float, kMostTaps * kMostTaps> right{}, down{};
};

/// Indexed by the number of taps in a row, minus one, and in a column, minus one.
constexpr std::array<std::array<Taps, kMostTaps>, kMostTaps> makeTaps() {
  std::array<std::array<Taps, kMostTaps>, kMostTaps> all{};
  const auto middle = [](std::size_t i, std::size_t count) {
    return (static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F;
  };
  for (std::size_t columns = 1; columns <= kMostTaps; ++columns) {
    for (std::size_t rows = 1; rows <= kMostTaps; ++rows) {
      Taps& taps = all[columns - 1][rows - 1];
      for (std::size_t i = 0; i < columns * rows; ++i) {
        taps.right[i] = middle(i % columns, columns);
        taps.down[i] = middle(i / columns, rows);
      }
    }
  }
  return all;
}

}  // namespace

PicturePyramid::PicturePyramid(const world::Texture& texture, PixelMeaning meaning)
    : levels_{toLight(texture.pixels, meaning)} {
  for (const cv::Mat& level : mipmapsOf(texture.pixels, meaning)) {
    levels_.push_back(toLight(level, meaning));
  }
}

Eigen::Vector2f PicturePyramid::inTexels(const Eigen::Vector2f& step) const {
  return {step.x() * static_cast<float>(levels_[0].cols),
          step.y() * static_cast<float>(levels_[0].rows)};
}

Eigen::Vector4f PicturePyramid::mean(const Eigen::Vector2f& place, const Eigen::Vector2f& across,
                                     const Eigen::Vector2f& along) const {
  constexpr auto kMost = static_cast<float>(kMostTaps);
  const float width = inTexels(across).norm();
  const float height = inTexels(along).norm();
  // Each tap covers a square that is half as wide as the pixel's narrower side.
  const float side =
      std::max({0.5F * std::min(width, height), std::max(width, height) / kMost, 0.5F});
  // 1 for NaN, as from a ray in a triangle's plane, which meets it at no definite place.
  const auto taps = [&](float length) {
    const float wanted = std::max(1.0F, std::ceil(length / side - 0.01F));
    return static_cast<std::size_t>(std::min(wanted, kMost));
  };
  static constexpr auto kTaps = makeTaps();
  const std::size_t columns = taps(width);
  const std::size_t rows = taps(height);
  const Taps& all = kTaps[columns - 1][rows - 1];
  const int count = static_cast<int>(columns * rows);
  const float level = std::log2(side);
  Lanes sum = lanes(0.0F);
  for (int tap = 0; tap < count; tap += kLaneCount) {
    const Lanes right = cv::v_load(&all.right[static_cast<std::size_t>(tap)]);
    const Lanes down = cv::v_load(&all.down[static_cast<std::size_t>(tap)]);
    sum = sumAt({lanes(place.x()) + right * lanes(across.x()) + down * lanes(along.x()),
                 lanes(place.y()) + right * lanes(across.y()) + down * lanes(along.y())},
                std::min(count - tap, kLaneCount), level, sum);
  }
  return colourOf(sum, static_cast<float>(count));
}

Eigen::Vector4f PicturePyramid::sample(const Eigen::Vector2f& place, const Eigen::Vector2f& across,
                                       const Eigen::Vector2f& along) const {
  const float longest = std::max(inTexels(across).norm(), inTexels(along).norm());
  const FourPlaces here{lanes(place.x()), lanes(place.y())};
  return colourOf(sumAt(here, 1, std::log2(std::max(longest, 1.0F)), lanes(0.0F)), 1.0F);
}

/// Adds the colours of the first places to a sum, one after the other.
Lanes PicturePyramid::sumAt(FourPlaces places, int count, float level, Lanes sum) const {
  const auto last = static_cast<float>(levels_.size() - 1);
  const float within = std::min(std::max(0.0F, level), last);  // 0 for NaN
  const auto lower = static_cast<std::size_t>(within);
  const float share = within - static_cast<float>(lower);
  const Lanes x = fractionOf(places.x);
  const Lanes y = fractionOf(places.y);
  const PlacesOnLevel sharp(x, y, levels_[lower]);
  if (share == 0.0F) {
    for (int i = 0; i < count; ++i) sum = sum + sharp.mixedAt(static_cast<std::size_t>(i));
    return sum;
  }
  const PlacesOnLevel blurred(x, y, levels_[lower + 1]);
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    sum = sum + mix(sharp.mixedAt(place), blurred.mixedAt(place), lanes(share));
  }
  return sum;
}

std::shared_ptr<const PicturePyramid> PyramidLibrary::get(
    const std::shared_ptr<const world::Texture>& texture, PixelMeaning meaning) {
  auto& pyramid = pyramids_[{texture, meaning}];
  if (!pyramid) pyramid = std::make_shared<const PicturePyramid>(*texture, meaning);
  return pyramid;
}

void PyramidLibrary::forgetUnused() {
  std::map<const world::Texture*, long> held_here;  // twice if used as both colours and data
  for (const auto& [key, pyramid] : pyramids_) ++held_here[key.first.get()];
  for (auto entry = pyramids_.begin(); entry != pyramids_.end();) {
    const auto& texture = entry->first.first;
    const bool is_used = texture.use_count() > held_here.at(texture.get());
    entry = is_used ? std::next(entry) : pyramids_.erase(entry);
  }
}

}  // namespace synthetic_dataset::render

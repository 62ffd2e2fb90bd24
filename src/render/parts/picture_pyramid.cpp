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

/// As std::floor(), for which processors have no instruction that all of them have.
float floorOf(float number) {
  constexpr float kWhole = 0x1p23F;  // from here on, numbers of single precision are whole
  if (!(std::abs(number) < kWhole)) return number;
  const auto nearer_to_0 = static_cast<float>(static_cast<int>(number));
  return nearer_to_0 > number ? nearer_to_0 - 1.0F : nearer_to_0;
}

/// Blue, green, red and alpha of a texel.
Lanes texelAt(const std::uint16_t* row, int column) {
  return cv::v_cvt_f32(
      cv::v_reinterpret_as_s32(cv::v_load_expand(row + std::ptrdiff_t{4} * column)));
}

/// Between the four texels around a place. Coordinates go on at the opposite edge.
Lanes mixedAt(const Eigen::Vector2f& place, const cv::Mat& level) {
  const float x = (place.x() - floorOf(place.x())) * static_cast<float>(level.cols) - 0.5F;
  const float y = (place.y() - floorOf(place.y())) * static_cast<float>(level.rows) - 0.5F;
  if (!(std::abs(x) < 1e6F && std::abs(y) < 1e6F)) return texelAt(level.ptr<std::uint16_t>(0), 0);
  const float left = floorOf(x);  // from -1 on
  const float top = floorOf(y);
  const int u = left < 0.0F ? level.cols - 1 : static_cast<int>(left);
  const int v = top < 0.0F ? level.rows - 1 : static_cast<int>(top);
  const int next_u = u + 1 == level.cols ? 0 : u + 1;
  const int next_v = v + 1 == level.rows ? 0 : v + 1;
  const auto* above = level.ptr<std::uint16_t>(v);
  const auto* below = level.ptr<std::uint16_t>(next_v);
  const Lanes share = lanes(x - left);
  return mix(mix(texelAt(above, u), texelAt(above, next_u), share),
             mix(texelAt(below, u), texelAt(below, next_u), share), lanes(y - top));
}

Eigen::Vector4f colourOf(const Lanes& sum, float count) {
  constexpr float kFull = 65535.0F;
  std::array<float, kLaneCount> bgra;
  cv::v_store(bgra.data(), sum * lanes(1.0F / (kFull * count)));
  return {bgra[2], bgra[1], bgra[0], bgra[3]};
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
  constexpr float kMostTaps = 4.0F;
  const float width = inTexels(across).norm();
  const float height = inTexels(along).norm();
  // Each tap covers a square, half as wide as the pixel where it is narrow.
  const float side =
      std::max({0.5F * std::min(width, height), std::max(width, height) / kMostTaps, 0.5F});
  const auto taps = [&](float length) {
    return static_cast<int>(std::clamp(std::ceil(length / side - 0.01F), 1.0F, kMostTaps));
  };
  const int columns = taps(width);
  const int rows = taps(height);
  const float level = std::log2(side);
  if (columns == 1 && rows == 1) return colourOf(at(place, level), 1.0F);
  Lanes sum = lanes(0.0F);
  for (int row = 0; row < rows; ++row) {
    const float b = (static_cast<float>(row) + 0.5F) / static_cast<float>(rows) - 0.5F;
    for (int column = 0; column < columns; ++column) {
      const float a = (static_cast<float>(column) + 0.5F) / static_cast<float>(columns) - 0.5F;
      sum = sum + at(Eigen::Vector2f(place + a * across + b * along), level);
    }
  }
  return colourOf(sum, static_cast<float>(columns * rows));
}

Eigen::Vector4f PicturePyramid::sample(const Eigen::Vector2f& place, const Eigen::Vector2f& across,
                                       const Eigen::Vector2f& along) const {
  const float longest = std::max(inTexels(across).norm(), inTexels(along).norm());
  return colourOf(at(place, std::log2(std::max(longest, 1.0F))), 1.0F);
}

Lanes PicturePyramid::at(const Eigen::Vector2f& place, float level) const {
  const float within = std::clamp(level, 0.0F, static_cast<float>(levels_.size() - 1));
  const auto lower = static_cast<std::size_t>(within);
  const float share = within - static_cast<float>(lower);
  const Lanes sharp = mixedAt(place, levels_[lower]);
  if (share == 0.0F) return sharp;
  return mix(sharp, mixedAt(place, levels_[lower + 1]), lanes(share));
}

std::shared_ptr<const PicturePyramid> PyramidLibrary::get(
    const std::shared_ptr<const world::Texture>& texture, PixelMeaning meaning) {
  auto& pyramid = pyramids_[{texture, meaning}];
  if (!pyramid) pyramid = std::make_shared<const PicturePyramid>(*texture, meaning);
  return pyramid;
}

void PyramidLibrary::forgetUnused() {
  std::map<const world::Texture*, long> held_here;  // twice where it is colours and data
  for (const auto& [key, pyramid] : pyramids_) ++held_here[key.first.get()];
  for (auto entry = pyramids_.begin(); entry != pyramids_.end();) {
    const auto& texture = entry->first.first;
    const bool is_used = texture.use_count() > held_here.at(texture.get());
    entry = is_used ? std::next(entry) : pyramids_.erase(entry);
  }
}

}  // namespace synthetic_dataset::render

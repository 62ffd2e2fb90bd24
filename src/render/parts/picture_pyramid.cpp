#include "render/parts/picture_pyramid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "render/pixels/mipmaps.h"
#include "render/sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

int wrapped(int index, int count) {
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

}  // namespace

PicturePyramid::PicturePyramid(const world::Texture& texture, PixelMeaning meaning)
    : is_colour_(meaning == PixelMeaning::kColour), levels_{texture.pixels} {
  for (const cv::Mat& level : mipmapsOf(texture.pixels, meaning)) levels_.push_back(level);
}

Eigen::Vector2f PicturePyramid::inTexels(const Eigen::Vector2f& step) const {
  return {step.x() * static_cast<float>(levels_[0].cols),
          step.y() * static_cast<float>(levels_[0].rows)};
}

Eigen::Vector4f PicturePyramid::mean(const Eigen::Vector2f& place, const Eigen::Vector2f& across,
                                     const Eigen::Vector2f& along) const {
  constexpr float kMostTaps = 4.0F;
  const float width = std::max(inTexels(across).norm(), 1e-6F);
  const float height = std::max(inTexels(along).norm(), 1e-6F);
  // A tap covers a square: as many as it takes along each step, each half as wide as the pixel.
  const float side =
      std::max({0.5F * std::min(width, height), width / kMostTaps, height / kMostTaps, 0.5F});
  const auto taps = [&](float length) {
    return static_cast<int>(std::clamp(std::ceil(length / side - 0.01F), 1.0F, kMostTaps));
  };
  const int columns = taps(width);
  const int rows = taps(height);
  const float level = std::log2(side);
  Eigen::Vector4f sum = Eigen::Vector4f::Zero();
  for (int row = 0; row < rows; ++row) {
    const float b = (static_cast<float>(row) + 0.5F) / static_cast<float>(rows) - 0.5F;
    for (int column = 0; column < columns; ++column) {
      const float a = (static_cast<float>(column) + 0.5F) / static_cast<float>(columns) - 0.5F;
      sum += at(Eigen::Vector2f(place + a * across + b * along), level);
    }
  }
  return sum / static_cast<float>(columns * rows);
}

Eigen::Vector4f PicturePyramid::sample(const Eigen::Vector2f& place, const Eigen::Vector2f& across,
                                       const Eigen::Vector2f& along) const {
  const float longest = std::max(inTexels(across).norm(), inTexels(along).norm());
  return at(place, std::log2(std::max(longest, 1e-6F)));
}

Eigen::Vector4f PicturePyramid::at(const Eigen::Vector2f& place, float level) const {
  const auto last = static_cast<float>(levels_.size() - 1);
  const float within = std::clamp(level, 0.0F, last);
  const auto lower = static_cast<std::size_t>(within);
  const float share = within - static_cast<float>(lower);
  const Eigen::Vector4f sharp = at(place, levels_[lower]);
  if (share == 0.0F) return sharp;
  return sharp + share * (at(place, levels_[lower + 1]) - sharp);
}

Eigen::Vector4f PicturePyramid::at(const Eigen::Vector2f& place, const cv::Mat& level) const {
  const Eigen::Vector2f whole(std::floor(place.x()), std::floor(place.y()));
  const Eigen::Vector2f within = place - whole;
  const float x = within.x() * static_cast<float>(level.cols) - 0.5F;
  const float y = within.y() * static_cast<float>(level.rows) - 0.5F;
  if (!(std::abs(x) < 1e6F && std::abs(y) < 1e6F)) return texel(level.at<cv::Vec4b>(0, 0));
  const float left = std::floor(x);
  const float top = std::floor(y);
  const int u = wrapped(static_cast<int>(left), level.cols);
  const int v = wrapped(static_cast<int>(top), level.rows);
  const int next_u = u + 1 == level.cols ? 0 : u + 1;
  const int next_v = v + 1 == level.rows ? 0 : v + 1;
  const float a = x - left;
  const float b = y - top;
  const auto* above = level.ptr<cv::Vec4b>(v);
  const auto* below = level.ptr<cv::Vec4b>(next_v);
  return (1.0F - b) * ((1.0F - a) * texel(above[u]) + a * texel(above[next_u])) +
         b * ((1.0F - a) * texel(below[u]) + a * texel(below[next_u]));
}

Eigen::Vector4f PicturePyramid::texel(const cv::Vec4b& texel) const {
  constexpr float kFull = 255.0F;
  const float alpha = static_cast<float>(texel[3]) / kFull;
  if (is_colour_) {
    const auto& light = render::linearFromSrgb();
    return {light[texel[2]], light[texel[1]], light[texel[0]], alpha};
  }
  return {static_cast<float>(texel[2]) / kFull, static_cast<float>(texel[1]) / kFull,
          static_cast<float>(texel[0]) / kFull, alpha};
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

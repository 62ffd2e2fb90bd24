#include "render/light/panorama_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>

#include "render/light/lobe_blur.h"
#include "render/light/panorama_lookup.h"
#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {
namespace {

/// GGX's alpha of each level: a mirror, its picture with fewer pixels, and blurred ones.
constexpr std::array<float, 9> kAlphas = {0.0F,     1.0F / 256, 1.0F / 64, 1.0F / 32, 1.0F / 16,
                                          1.0F / 8, 1.0F / 4,   1.0F / 2,  1.0F};
constexpr std::size_t kFirstBlurred = 2;

constexpr int kMatteRows = 64;  // of the copy whose pixels are all added up

/// Two or more pixels for the width of a level's lobe.
int rowsOf(std::size_t level) {
  constexpr int kSharpest = 256;
  constexpr int kLeast = 32;
  return std::max(kSharpest >> (level - kFirstBlurred), kLeast);
}

/// @param panorama  CV_32FC4
/// @return with so few rows that all their pixels are soon added up
cv::Mat reduced(const cv::Mat& panorama) {
  cv::Mat light;
  cv::resize(panorama, light, {2 * kMatteRows, kMatteRows}, 0.0, 0.0, cv::INTER_AREA);
  return light;
}

/// @param panorama  CV_16UC4 @return CV_32FC4
cv::Mat toFloats(const cv::Mat& panorama) {
  cv::Mat floats(panorama.size(), CV_32FC4);
  for (int row = 0; row < panorama.rows; ++row) {
    const auto* from = panorama.ptr<std::uint16_t>(row);
    auto* to = floats.ptr<float>(row);
    for (int i = 0; i < 4 * panorama.cols; i += kLaneCount) {
      cv::v_store(to + i, fromHalf(cv::v_load_expand(from + i)));
    }
  }
  return floats;
}

/// @param panorama  CV_32FC4 @return CV_16UC4
cv::Mat toHalves(const cv::Mat& panorama) {
  constexpr float kMost = 65504.0F;
  cv::Mat halves(panorama.size(), CV_16UC4);
  for (int row = 0; row < panorama.rows; ++row) {
    const auto* from = panorama.ptr<float>(row);
    auto* to = halves.ptr<std::uint16_t>(row);
    for (int i = 0; i < 4 * panorama.cols; i += kLaneCount) {
      cv::v_pack_store(to + i, halfFrom(clamped(cv::v_load(from + i), 0.0F, kMost)));
    }
  }
  return halves;
}

/// @param panorama  CV_16UC4
/// @return CV_32FC4, at most 1024 pixels wide
cv::Mat smaller(const cv::Mat& panorama) {
  constexpr int kMostColumns = 1024;
  cv::Mat light = toFloats(panorama);
  if (light.cols > kMostColumns) {
    cv::resize(light, light, {kMostColumns, kMostColumns / 2}, 0.0, 0.0, cv::INTER_AREA);
  }
  return light;
}

/// Between which levels a lobe lies: whole at each of kAlphas, and even in the logarithm between
/// those that are not 0.
Lanes levelOf(const Lanes& roughness) {
  constexpr float kPerTwo = 1.44269504F;
  const Lanes alpha = roughness * roughness;
  const Lanes twos = logarithm(alpha) * lanes(kPerTwo);
  const Lanes sharp = alpha * lanes(256.0F);
  const Lanes between = lanes(5.0F) + lanes(0.5F) * twos;
  const Lanes blurred = lanes(8.0F) + twos;
  const Lanes level = cv::v_select(alpha < lanes(1.0F / 64), between, blurred);
  return clamped(cv::v_select(alpha < lanes(1.0F / 256), sharp, level), 0.0F,
                 kAlphas.size() - 1.0F);
}

/// What levels show of four places.
/// @param which  level of each
Lanes3 shown(const std::vector<cv::Mat>& levels, const std::array<int, kLaneCount>& which,
             const PanoramaPlaces& places) {
  const auto level = [&](std::size_t lane) -> const cv::Mat& {
    return levels[static_cast<std::size_t>(which[lane])];
  };
  const auto load = [](const std::uint16_t* pixels) { return loadHalves(pixels).xyz; };
  return seenBetween<cv::Vec4w>(places, level, load);
}

}  // namespace

PanoramaLight::PanoramaLight(const cv::Mat& panorama)
    : PanoramaLight(panorama, smaller(panorama)) {}

PanoramaLight::PanoramaLight(const cv::Mat& panorama, const cv::Mat& light)
    : above_(reduced(light), 0, kMatteRows / 2),
      below_(reduced(light), kMatteRows / 2, kMatteRows),
      levels_{bordered(panorama), bordered(toHalves(light))} {
  const std::vector<cv::Mat> copies = smallerPanoramas(light);
  for (std::size_t level = kFirstBlurred; level < kAlphas.size(); ++level) {
    levels_.push_back(
        bordered(toHalves(blurredByLobe(copies, double{kAlphas[level]}, rowsOf(level)))));
  }
}

Lanes3 PanoramaLight::mirrored(const Lanes3& directions, const Lanes& roughness) const {
  const PanoramaPlaces places = placesOf(directions);
  const Lanes level = levelOf(roughness);
  const cv::v_int32x4 whole = cv::v_trunc(level);
  std::array<int, kLaneCount> which{};
  cv::v_store(which.data(), whole);
  const Lanes share = level - cv::v_cvt_f32(whole);
  const Lanes3 sharper = shown(levels_, which, places);
  if (cv::v_check_all(share == lanes(0.0F))) return sharper;
  for (int& each : which) each = std::min(each + 1, static_cast<int>(levels_.size()) - 1);
  return mix(sharper, shown(levels_, which, places), share);
}

std::size_t PanoramaLight::memory() const {
  std::size_t bytes = 0;
  for (const cv::Mat& level : levels_) bytes += level.total() * level.elemSize();
  return bytes;
}

cv::Mat panoramaOf(const world::Texture& picture) {
  constexpr int kMostColumns = 2048;
  cv::Mat light = toLight(picture.pixels, PixelMeaning::kColour);
  if (light.cols > kMostColumns) {
    cv::resize(light, light, {kMostColumns, kMostColumns / 2}, 0.0, 0.0, cv::INTER_AREA);
  }
  cv::Mat rgba;
  cv::cvtColor(light, rgba, cv::COLOR_BGRA2RGBA);
  if (rgba.depth() == CV_16U) rgba.convertTo(rgba, CV_32F, 1.0 / 65535.0);
  return toHalves(rgba);
}

}  // namespace synthetic_dataset::render

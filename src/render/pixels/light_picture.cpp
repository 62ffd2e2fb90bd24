#include "render/pixels/light_picture.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

constexpr float kWhite = 65535.0F;
constexpr int kAlpha = 3;
constexpr int kStep = 257;  // 65535 / 255

bool isLight(PixelMeaning meaning, int channel) {
  return meaning == PixelMeaning::kColour && channel != kAlpha;
}

/// The number that toLight() gives for each byte value in each channel.
cv::Mat makeTable(PixelMeaning meaning) {
  cv::Mat table(1, 256, CV_16UC4);
  for (int i = 0; i < table.cols; ++i) {
    const float light = render::linearFromSrgb()[static_cast<std::size_t>(i)];
    for (int c = 0; c < table.channels(); ++c) {
      table.at<cv::Vec4w>(i)[c] =
          static_cast<std::uint16_t>(isLight(meaning, c) ? std::lround(kWhite * light) : kStep * i);
    }
  }
  return table;
}

}  // namespace

cv::Mat toLight(const cv::Mat& picture, PixelMeaning meaning) {
  if (picture.depth() == CV_32F) return picture;
  static const cv::Mat kColours = makeTable(PixelMeaning::kColour);
  static const cv::Mat kData = makeTable(PixelMeaning::kData);
  cv::Mat light;
  cv::LUT(picture, meaning == PixelMeaning::kColour ? kColours : kData, light);
  return light;
}

cv::Mat fromLight(const cv::Mat& light, PixelMeaning meaning) {
  if (light.depth() == CV_32F) return light;
  cv::Mat picture(light.size(), CV_8UC4);
  for (int v = 0; v < light.rows; ++v) {
    const auto* from = light.ptr<cv::Vec4w>(v);
    auto* to = picture.ptr<cv::Vec4b>(v);
    for (int u = 0; u < light.cols; ++u) {
      for (int c = 0; c < light.channels(); ++c) {
        to[u][c] = isLight(meaning, c)
                       ? render::srgbFromLinear(static_cast<float>(from[u][c]) / kWhite)
                       : static_cast<std::uint8_t>((from[u][c] + kStep / 2) / kStep);
      }
    }
  }
  return picture;
}

}  // namespace synthetic_dataset::render

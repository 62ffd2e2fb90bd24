#include "render/overlay/backdrop_fitting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

constexpr float kWhite = 65535.0F;

/// Linear light of 16 bits, blue green red, of each encoded value.
cv::Mat linearTable() {
  cv::Mat table(1, 256, CV_16UC1);
  for (int i = 0; i < table.cols; ++i) {
    const float light = sensor::linearFromSrgb()[static_cast<std::size_t>(i)];
    table.at<std::uint16_t>(i) = static_cast<std::uint16_t>(std::lround(kWhite * light));
  }
  return table;
}

cv::Mat toLight(const cv::Mat& picture) {
  static const cv::Mat kTable = linearTable();
  cv::Mat light;
  cv::LUT(picture, kTable, light);
  return light;
}

cv::Mat encoded(const cv::Mat& light) {
  cv::Mat picture(light.size(), CV_8UC4);
  for (int v = 0; v < light.rows; ++v) {
    const auto* from = light.ptr<std::uint16_t>(v);
    auto* to = picture.ptr<std::uint8_t>(v);
    for (int i = 0; i < 4 * light.cols; ++i) {
      to[i] = sensor::srgbFromLinear(static_cast<float>(from[i]) / kWhite);
    }
  }
  return picture;
}

int share(int length, int numerator, int denominator) {
  const double exact = static_cast<double>(length) * numerator / denominator;
  return std::max(1, static_cast<int>(std::lround(exact)));
}

}  // namespace

cv::Rect partFilling(const cv::Size& picture, const cv::Size& image) {
  const cv::Size part(std::min(picture.width, share(picture.height, image.width, image.height)),
                      std::min(picture.height, share(picture.width, image.height, image.width)));
  return {cv::Point((picture.width - part.width) / 2, (picture.height - part.height) / 2), part};
}

cv::Mat scaledTo(const cv::Size& size, const cv::Mat& picture) {
  if (picture.size() == size) return picture;
  const bool shrinks = size.width < picture.cols || size.height < picture.rows;
  cv::Mat light;
  cv::resize(toLight(picture), light, size, 0.0, 0.0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  return encoded(light);
}

}  // namespace synthetic_dataset::render

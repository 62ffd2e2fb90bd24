#include "render/sensor/linear_accumulator.h"

#include "render/sensor/srgb.h"

namespace synthetic_dataset::render {

LinearAccumulator::LinearAccumulator(const cv::Size& size)
    : light_(size, CV_32FC3, cv::Scalar::all(0.0)) {}

void LinearAccumulator::add(const cv::Mat& pixels, const cv::Rect& region, double weight) {
  cv::Mat part = light_(region);
  const auto& linear = linearFromSrgb();
  const auto share = static_cast<float>(weight);
  for (int v = 0; v < part.rows; ++v) {
    const auto* from = pixels.ptr<cv::Vec3b>(v);
    auto* to = part.ptr<cv::Vec3f>(v);
    for (int u = 0; u < part.cols; ++u) {
      for (int channel = 0; channel < 3; ++channel) {
        to[u][channel] += share * linear[from[u][channel]];
      }
    }
  }
}

cv::Mat LinearAccumulator::result() const {
  cv::Mat picture(light_.size(), CV_8UC3);
  for (int v = 0; v < picture.rows; ++v) {
    const auto* from = light_.ptr<cv::Vec3f>(v);
    auto* to = picture.ptr<cv::Vec3b>(v);
    for (int u = 0; u < picture.cols; ++u) {
      for (int channel = 0; channel < 3; ++channel) {
        to[u][channel] = srgbFromLinear(from[u][channel]);
      }
    }
  }
  return picture;
}

void LinearAccumulator::clear() { light_.setTo(0.0); }

}  // namespace synthetic_dataset::render

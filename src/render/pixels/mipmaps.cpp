#include "render/pixels/mipmaps.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::render {

std::vector<cv::Mat> mipmapsOf(const cv::Mat& picture, PixelMeaning meaning) {
  std::vector<cv::Mat> mipmaps;
  if (picture.total() <= 1) return mipmaps;
  for (cv::Mat light = toLight(picture, meaning); light.total() > 1;) {
    const cv::Size half(std::max(1, light.cols / 2), std::max(1, light.rows / 2));
    cv::Mat smaller;
    cv::resize(light, smaller, half, 0.0, 0.0, cv::INTER_AREA);
    light = smaller;
    mipmaps.push_back(fromLight(light, meaning));
  }
  return mipmaps;
}

}  // namespace synthetic_dataset::render

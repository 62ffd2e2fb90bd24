#include "label/alignment.h"

#include <algorithm>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::label {
namespace {

int contrastOf(const cv::Vec3b& a, const cv::Vec3b& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

/// Adds the contrast across an outline between a pixel and the next one along `step`.
void addContrast(const cv::Mat_<cv::Vec3b>& picture, const cv::Point& pixel, const cv::Point& step,
                 Alignment& sum) {
  const cv::Rect image({0, 0}, picture.size());
  int met = 0;
  int most = 0;
  for (int i = -Alignment::kReach; i <= Alignment::kReach; ++i) {
    const cv::Point here = pixel + i * step;
    if (!image.contains(here) || !image.contains(here + step)) continue;
    const int contrast = contrastOf(picture(here), picture(here + step));
    most = std::max(most, contrast);
    if (i == 0) met = contrast;
  }
  sum.met += met;
  sum.most += most;
}

}  // namespace

cv::Mat smoothed(const cv::Mat& picture) {
  cv::Mat smooth;
  cv::GaussianBlur(picture, smooth, cv::Size(7, 7), 1.0);
  return smooth;
}

Alignment alignmentOf(const Mask& mask, const cv::Mat& picture) {
  Alignment sum;
  const cv::Rect image({0, 0}, picture.size());
  const cv::Rect bounds = mask.bounds();
  const cv::Mat_<uchar> inside = mask.pixels();
  const auto isInside = [&](const cv::Point& at) {
    return bounds.contains(at) && inside(at - bounds.tl()) != 0;
  };
  // Starts one pixel before the mask's box: a pair is visited at its left or upper pixel.
  for (int y = std::max(bounds.y - 1, 0); y < bounds.br().y; ++y) {
    for (int x = std::max(bounds.x - 1, 0); x < bounds.br().x; ++x) {
      const cv::Point pixel(x, y);
      for (const cv::Point& step : {cv::Point(1, 0), cv::Point(0, 1)}) {
        if (!image.contains(pixel + step) || isInside(pixel) == isInside(pixel + step)) continue;
        addContrast(picture, pixel, step, sum);
      }
    }
  }
  return sum;
}

std::vector<Alignment> alignmentsOf(const Scene& scene, const cv::Mat& recorded) {
  const cv::Mat picture = smoothed(recorded);
  std::vector<Alignment> all;
  for (const SceneObject& object : scene.objects) {
    all.push_back(object.visible_mask.isKnown() ? alignmentOf(object.visible_mask(), picture)
                                                : Alignment());
  }
  return all;
}

}  // namespace synthetic_dataset::label

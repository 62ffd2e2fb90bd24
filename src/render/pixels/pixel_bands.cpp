#include "render/pixels/pixel_bands.h"

#include <algorithm>
#include <functional>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::render {
namespace {

constexpr int kLeastGap = 8;  // [px] between two rectangles of a band

/// Appends the runs of pixels that are not 0, joining those with small gaps between them.
void addRuns(const std::vector<uchar>& is_set, int top, int height, std::vector<cv::Rect>& to) {
  int first = -1;
  int end = 0;
  for (int u = 0; u < static_cast<int>(is_set.size()); ++u) {
    if (is_set[static_cast<std::size_t>(u)] == 0) continue;
    if (first >= 0 && u - end >= kLeastGap) {
      to.emplace_back(first, top, end - first, height);
      first = -1;
    }
    if (first < 0) first = u;
    end = u + 1;
  }
  if (first >= 0) to.emplace_back(first, top, end - first, height);
}

}  // namespace

/// Bands are aligned to multiples of `height`.
std::vector<cv::Rect> bandsOf(const cv::Mat& pixels, int height) {
  std::vector<cv::Rect> bands;
  std::vector<uchar> columns(static_cast<std::size_t>(pixels.cols));
  const cv::Rect bounds = maskBounds(pixels);
  const int bottom = bounds.y + bounds.height;
  for (int band = bounds.y / height; band * height < bottom; ++band) {
    const int top = std::max(band * height, bounds.y);
    const int end = std::min((band + 1) * height, bottom);
    std::fill(columns.begin(), columns.end(), uchar{0});
    for (int row = top; row < end; ++row) {
      const auto* is_set = pixels.ptr<uchar>(row);
      std::transform(columns.begin(), columns.end(), is_set, columns.begin(), std::bit_or<>());
    }
    addRuns(columns, top, end - top, bands);
  }
  return bands;
}

cv::Mat withPixelsAround(const cv::Mat& pixels, int distance) {
  cv::Mat result;
  cv::dilate(pixels, result, cv::Mat(), cv::Point(-1, -1), distance);  // one pixel per iteration
  return result;
}

cv::Rect grown(const cv::Rect& rectangle, int distance) {
  const cv::Point more(distance, distance);
  return {rectangle.tl() - more, rectangle.br() + more};
}

cv::Rect boundsOf(const std::vector<cv::Rect>& rectangles) {
  cv::Rect bounds;  // in OpenCV the union with an empty rectangle is the other one
  for (const cv::Rect& each : rectangles) bounds |= each;
  return bounds;
}

}  // namespace synthetic_dataset::render

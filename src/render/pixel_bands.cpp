#include "render/pixel_bands.h"

#include <algorithm>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::render {
namespace {

constexpr int kHeight = 16;    // [px] of a band
constexpr int kLeastGap = 16;  // [px] between two rectangles of a band

/// The runs of pixels that are not 0, those with small gaps between them as one.
void addRuns(const cv::Mat& row, int top, int height, std::vector<cv::Rect>& to) {
  const auto* is_set = row.ptr<uchar>();
  int first = -1;
  int end = 0;
  for (int u = 0; u < row.cols; ++u) {
    if (is_set[u] == 0) continue;
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

std::vector<cv::Rect> bandsOf(const cv::Mat& pixels) {
  std::vector<cv::Rect> bands;
  cv::Mat columns;
  const cv::Rect bounds = cv::boundingRect(pixels);
  for (int top = bounds.y; top < bounds.y + bounds.height; top += kHeight) {
    const int height = std::min(kHeight, bounds.y + bounds.height - top);
    cv::reduce(pixels.rowRange(top, top + height), columns, 0, cv::REDUCE_MAX);
    addRuns(columns, top, height, bands);
  }
  return bands;
}

cv::Rect boundsOf(const std::vector<cv::Rect>& rectangles) {
  cv::Rect bounds;  // OpenCV's union with an empty rectangle is the other one
  for (const cv::Rect& each : rectangles) bounds |= each;
  return bounds;
}

}  // namespace synthetic_dataset::render

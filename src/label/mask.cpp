#include "label/mask.h"

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::label {
namespace {

constexpr unsigned char kForeground = 255;

/// Sets every connected region of `value` with at most `largest` pixels to `replacement`.
/// @return the number of regions of `value` that were left
int replaceSmallRegions(cv::Mat& mask, unsigned char value, int largest, int connectivity,
                        unsigned char replacement) {
  cv::Mat regions;
  cv::Mat statistics;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(mask == value, regions, statistics, centroids,
                                                     connectivity, CV_32S);
  int left = 0;
  for (int region = 1; region < count; ++region) {  // 0 is everything else
    if (statistics.at<int>(region, cv::CC_STAT_AREA) > largest) {
      ++left;
      continue;
    }
    const cv::Rect place(statistics.at<int>(region, cv::CC_STAT_LEFT),
                         statistics.at<int>(region, cv::CC_STAT_TOP),
                         statistics.at<int>(region, cv::CC_STAT_WIDTH),
                         statistics.at<int>(region, cv::CC_STAT_HEIGHT));
    mask(place).setTo(replacement, regions(place) == region);
  }
  return left;
}

}  // namespace

cv::Mat cleanMask(const cv::Mat& raw) {
  cv::Mat mask = raw == kForeground;
  // A hole is filled if it touches the outside at most by a corner: 4-connected background,
  // 8-connected object.
  replaceSmallRegions(mask, 0, kLargestHole, 4, kForeground);
  cv::Mat without_specks = mask.clone();
  const int left = replaceSmallRegions(without_specks, kForeground, kLargestSpeck, 8, 0);
  return left == 0 ? mask : without_specks;
}

}  // namespace synthetic_dataset::label

#include "label/occlusion.h"

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::label {
namespace {

constexpr int kNeighbours = 2;  // [px]

double shareOf(std::int64_t part, std::int64_t all) {
  return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace

cv::Mat coveredPixels(const cv::Mat& known, const cv::Mat& measured,
                      const OcclusionMargin& margin) {
  constexpr float kFarAway = 1e6F;  // [m], for the sky
  cv::Mat nearest = known.clone();
  nearest.setTo(kFarAway, known <= 0.0F);
  const int side = 2 * kNeighbours + 1;
  cv::erode(nearest, nearest, cv::Mat::ones(side, side, CV_8U));
  const cv::Mat in_front =
      measured < nearest * (1.0 - margin.growth) - cv::Scalar::all(margin.least);
  return in_front & (measured > 0.0F);
}

ObjectCover& ObjectCover::operator+=(const ObjectCover& other) {
  pixels += other.pixels;
  unmeasured += other.unmeasured;
  covered += other.covered;
  return *this;
}

double ObjectCover::unmeasuredShare() const { return shareOf(unmeasured, pixels); }

double ObjectCover::coveredShare() const { return shareOf(covered, pixels); }

std::vector<ObjectCover> objectCovers(const cv::Mat& ids, const cv::Mat& measured,
                                      const cv::Mat& covered, std::size_t object_count) {
  std::vector<ObjectCover> covers(object_count);
  for (int row = 0; row < ids.rows; ++row) {
    const int* const of_row = ids.ptr<int>(row);
    for (int column = 0; column < ids.cols; ++column) {
      if (of_row[column] == 0) continue;
      ObjectCover& cover = covers[static_cast<std::size_t>(of_row[column]) - 1];
      ++cover.pixels;
      if (measured.empty() || measured.at<float>(row, column) == 0.0F) {
        ++cover.unmeasured;
      } else if (covered.at<std::uint8_t>(row, column) != 0) {
        ++cover.covered;
      }
    }
  }
  return covers;
}

}  // namespace synthetic_dataset::label

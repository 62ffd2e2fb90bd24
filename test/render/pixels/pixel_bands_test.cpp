#include "render/pixels/pixel_bands.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::render {
namespace pixel_bands_test {

cv::Mat countsOf(const std::vector<cv::Rect>& rectangles, const cv::Size& size) {
  cv::Mat counts = cv::Mat::zeros(size, CV_8UC1);
  for (const cv::Rect& each : rectangles) counts(each) += 1;
  return counts;
}

class PixelBandsOfHeight : public testing::TestWithParam<int> {};

TEST_P(PixelBandsOfHeight, HoldAllPixelsOnceAndFewOthers) {
  cv::RNG random(3);
  for (int trial = 0; trial < 50; ++trial) {
    cv::Mat pixels = cv::Mat::zeros(100, 170, CV_8UC1);
    for (int i = random.uniform(0, 5); i > 0; --i) {
      cv::circle(pixels, {random.uniform(0, 170), random.uniform(0, 100)}, random.uniform(0, 30),
                 cv::Scalar(255), cv::FILLED);
    }
    const cv::Mat counts = countsOf(bandsOf(pixels, GetParam()), pixels.size());
    EXPECT_EQ(cv::countNonZero(pixels & (counts == 0)), 0);
    EXPECT_EQ(cv::countNonZero(counts > 1), 0);
    const cv::Rect bounds = maskBounds(pixels);
    EXPECT_EQ(cv::countNonZero(counts), cv::countNonZero(counts(bounds)));
  }
}

INSTANTIATE_TEST_SUITE_P(PixelBands, PixelBandsOfHeight, testing::Values(kFineBand, kCoarseBand));

TEST(PixelBands, FollowSlantedOutlines) {
  cv::Mat pixels = cv::Mat::zeros(200, 200, CV_8UC1);
  const std::vector<cv::Point> triangle = {{0, 13}, {199, 13}, {0, 190}};
  cv::fillConvexPoly(pixels, triangle, cv::Scalar(255));
  const cv::Mat counts = countsOf(bandsOf(pixels), pixels.size());
  EXPECT_LT(cv::countNonZero(counts), 1.06 * cv::countNonZero(pixels));
}

TEST(PixelBands, AreNoneForNoPixels) {
  EXPECT_TRUE(bandsOf(cv::Mat::zeros(20, 30, CV_8UC1)).empty());
}

TEST(PixelBands, LeaveWideGapsOut) {
  cv::Mat pixels = cv::Mat::zeros(10, 100, CV_8UC1);
  pixels(cv::Rect(2, 3, 5, 4)).setTo(1);
  pixels(cv::Rect(60, 3, 5, 4)).setTo(255);
  EXPECT_EQ(bandsOf(pixels), (std::vector<cv::Rect>{{2, 3, 5, 4}, {60, 3, 5, 4}}));
}

}  // namespace pixel_bands_test
}  // namespace synthetic_dataset::render

#include "label/mask.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::label {
namespace mask_test {

cv::Mat disc() {
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8UC1);
  cv::circle(mask, {40, 30}, 20, 255, cv::FILLED);
  return mask;
}

bool same(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0.0; }

TEST(CleanMask, LeavesACleanMaskAsItIs) { EXPECT_TRUE(same(cleanMask(disc()), disc())); }

TEST(CleanMask, TakesShadowForBackground) {
  cv::Mat raw = disc();
  cv::rectangle(raw, {0, 52}, {79, 59}, 127, cv::FILLED);
  EXPECT_TRUE(same(cleanMask(raw), disc()));
}

TEST(CleanMask, FillsSmallHolesAndKeepsLargeOnes) {
  cv::Mat raw = disc();
  raw(cv::Rect(35, 28, 4, 4)) = 0;  // 16 pixels
  raw(cv::Rect(44, 26, 6, 6)) = 0;  // 36 pixels: a real hole
  cv::Mat expected = disc();
  expected(cv::Rect(44, 26, 6, 6)) = 0;
  EXPECT_TRUE(same(cleanMask(raw), expected));
}

TEST(CleanMask, RemovesSpecks) {
  cv::Mat raw = disc();
  raw(cv::Rect(2, 2, 3, 1)) = 255;
  EXPECT_TRUE(same(cleanMask(raw), disc()));
}

TEST(CleanMask, KeepsAnObjectThatIsNoLargerThanASpeck) {
  cv::Mat raw = cv::Mat::zeros(20, 20, CV_8UC1);
  raw.at<unsigned char>(7, 9) = 255;
  EXPECT_TRUE(same(cleanMask(raw), raw));
}

}  // namespace mask_test
}  // namespace synthetic_dataset::label

#include "annotate/mog2_segmenter.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::annotate {
namespace {

/// A grey background with a patch whose three channels differ from it by `difference`.
cv::Mat patch(int difference) {
  cv::Mat image(40, 60, CV_8UC3, cv::Scalar::all(100));
  image(cv::Rect(10, 10, 20, 15)).setTo(cv::Scalar::all(100 + difference));
  return image;
}

cv::Mat expectedMask() {
  cv::Mat mask = cv::Mat::zeros(40, 60, CV_8UC1);
  mask(cv::Rect(10, 10, 20, 15)) = 255;
  return mask;
}

TEST(Mog2Segmenter, FindsExactlyThePixelsThatDiffer) {
  Mog2Segmenter segmenter({1, 16.0, false});
  segmenter.train(patch(0));
  EXPECT_EQ(cv::norm(segmenter.segment(patch(40)), expectedMask(), cv::NORM_INF), 0.0);
}

TEST(Mog2Segmenter, JudgesByTheSquaredDistanceOverTheVariance) {
  // After one picture the variance is 15, so foreground begins at 3 d^2 >= threshold * 15.
  Mog2Segmenter segmenter({1, 500.0, false});
  segmenter.train(patch(0));
  EXPECT_EQ(cv::countNonZero(segmenter.segment(patch(49))), 0);    // 3 * 49^2 = 7203 < 7500
  EXPECT_EQ(cv::countNonZero(segmenter.segment(patch(51))), 300);  // 3 * 51^2 = 7803
}

TEST(Mog2Segmenter, LearnsNothingFromWhatItSegments) {
  Mog2Segmenter segmenter({3, 16.0, false});
  segmenter.train(patch(0));
  for (int i = 0; i < 50; ++i) (void)segmenter.segment(patch(40));
  EXPECT_EQ(cv::norm(segmenter.segment(patch(40)), expectedMask(), cv::NORM_INF), 0.0);
}

TEST(Mog2Segmenter, ForgetsTheOldBackgroundWhenTrainedAnew) {
  Mog2Segmenter segmenter({1, 16.0, false});
  segmenter.train(patch(0));
  segmenter.train(patch(40));
  EXPECT_EQ(cv::countNonZero(segmenter.segment(patch(40))), 0);
}

TEST(Mog2Segmenter, HasToBeTrainedFirst) {
  Mog2Segmenter segmenter({1, 16.0, false});
  EXPECT_THROW((void)segmenter.segment(patch(0)), Error);
}

}  // namespace
}  // namespace synthetic_dataset::annotate

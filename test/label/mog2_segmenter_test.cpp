#include "label/mog2_segmenter.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::label {
namespace mog2_segmenter_test {

/// A grey background with a patch whose three channels differ from it by `difference`.
cv::Mat patch(int difference) {
  cv::Mat image(40, 60, CV_8UC3, cv::Scalar::all(100));
  image(cv::Rect(10, 10, 20, 15)).setTo(cv::Scalar::all(100 + difference));
  return image;
}

const cv::Rect kWhole(0, 0, 60, 40);

cv::Mat expectedMask() {
  cv::Mat mask = cv::Mat::zeros(40, 60, CV_8UC1);
  mask(cv::Rect(10, 10, 20, 15)) = 255;
  return mask;
}

TEST(Mog2Segmenter, FindsExactlyThePixelsThatDiffer) {
  Mog2Segmenter segmenter({1, 16.0, false});
  segmenter.train(patch(0));
  EXPECT_EQ(cv::norm(segmenter.segment(patch(40), kWhole), expectedMask(), cv::NORM_INF), 0.0);
}

TEST(Mog2Segmenter, JudgesByTheSquaredDistanceOverTheVariance) {
  // After one picture the variance is 15, so foreground begins at 3 d^2 >= threshold * 15.
  Mog2Segmenter segmenter({1, 500.0, false});
  segmenter.train(patch(0));
  EXPECT_EQ(cv::countNonZero(segmenter.segment(patch(49), kWhole)), 0);    // 3 * 49^2 = 7203 < 7500
  EXPECT_EQ(cv::countNonZero(segmenter.segment(patch(51), kWhole)), 300);  // 3 * 51^2 = 7803
}

TEST(Mog2Segmenter, LearnsNothingFromWhatItSegments) {
  Mog2Segmenter segmenter({3, 16.0, false});
  segmenter.train(patch(0));
  for (int i = 0; i < 50; ++i) (void)segmenter.segment(patch(40), kWhole);
  EXPECT_EQ(cv::norm(segmenter.segment(patch(40), kWhole), expectedMask(), cv::NORM_INF), 0.0);
}

TEST(Mog2Segmenter, ForgetsTheOldBackgroundWhenTrainedAnew) {
  Mog2Segmenter segmenter({1, 16.0, false});
  segmenter.train(patch(0));
  segmenter.train(patch(40));
  EXPECT_EQ(cv::countNonZero(segmenter.segment(patch(40), kWhole)), 0);
}

TEST(Mog2Segmenter, JudgesRegionsAsItWouldTheWholePicture) {
  // Noise, larger than a few tiles, compared with what OpenCV finds in the whole picture.
  cv::Mat background(150, 333, CV_8UC3);
  cv::Mat image(background.size(), CV_8UC3);
  cv::RNG random(7);
  random.fill(background, cv::RNG::UNIFORM, 60, 160);
  random.fill(image, cv::RNG::UNIFORM, 60, 160);
  const Mog2Options options{5, 100.0, true};
  const auto whole = cv::createBackgroundSubtractorMOG2(
      options.history_length, options.var_threshold, options.detect_shadows);
  cv::Mat expected;
  for (int i = 0; i < options.history_length; ++i) whole->apply(background, expected);
  whole->apply(image, expected, 0.0);
  Mog2Segmenter segmenter(options);
  segmenter.train(background);
  for (const cv::Rect& region : {cv::Rect(0, 0, 333, 150), cv::Rect(60, 60, 10, 10),
                                 cv::Rect(128, 64, 64, 64), cv::Rect(332, 149, 1, 1)}) {
    EXPECT_EQ(cv::norm(segmenter.segment(image, region), expected(region), cv::NORM_INF), 0.0)
        << region;
  }
}

TEST(Mog2Segmenter, HasToBeTrainedFirst) {
  Mog2Segmenter segmenter({1, 16.0, false});
  EXPECT_THROW((void)segmenter.segment(patch(0), kWhole), Error);
}

}  // namespace mog2_segmenter_test
}  // namespace synthetic_dataset::label

#include "render/sensor/linear_accumulator.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace linear_accumulator_test {

const cv::Size kSize(50, 3);  // rows of more than one block

cv::Mat grey(int value) { return {kSize, CV_8UC3, cv::Scalar::all(value)}; }

TEST(LinearAccumulator, AveragesLightAndNotItsEncoding) {
  LinearAccumulator light;
  light.add(grey(255), 0.5);
  light.add(grey(0), 0.5);
  EXPECT_EQ(cv::norm(light.result(), grey(188), cv::NORM_INF), 0.0);
}

TEST(LinearAccumulator, EqualPicturesStayAsTheyAre) {
  LinearAccumulator light;
  for (int i = 0; i < 7; ++i) light.add(grey(77), 1.0 / 7.0);
  EXPECT_EQ(cv::norm(light.result(), grey(77), cv::NORM_INF), 0.0);
}

TEST(LinearAccumulator, AveragesEachPixelByItself) {
  LinearAccumulator light;
  light.add(grey(100), 0.25);
  cv::Mat other = grey(100);
  other.at<cv::Vec3b>(1, 49) = {0, 100, 255};
  for (int i = 0; i < 3; ++i) light.add(other, 0.25);
  cv::Mat expected = grey(100);
  expected.at<cv::Vec3b>(1, 49) = {50, 100, 229};
  EXPECT_EQ(cv::norm(light.result(), expected, cv::NORM_INF), 0.0);
}

}  // namespace linear_accumulator_test
}  // namespace synthetic_dataset::render

#include "render/sensor/linear_accumulator.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::render {
namespace linear_accumulator_test {

const cv::Size kSize(4, 3);
const cv::Rect kWhole(0, 0, 4, 3);

cv::Mat grey(int value, const cv::Size& size = kSize) {
  return {size, CV_8UC3, cv::Scalar::all(value)};
}

TEST(LinearAccumulator, AveragesLightAndNotItsEncoding) {
  LinearAccumulator light(kSize);
  light.add(grey(255), kWhole, 0.5);
  light.add(grey(0), kWhole, 0.5);
  EXPECT_EQ(light.result().at<cv::Vec3b>(1, 1), cv::Vec3b(188, 188, 188));
}

TEST(LinearAccumulator, EqualPicturesStayAsTheyAre) {
  LinearAccumulator light(kSize);
  for (int i = 0; i < 7; ++i) light.add(grey(77), kWhole, 1.0 / 7.0);
  EXPECT_EQ(light.result().at<cv::Vec3b>(2, 3), cv::Vec3b(77, 77, 77));
}

TEST(LinearAccumulator, PartsFallWhereTheyBelong) {
  LinearAccumulator light(kSize);
  light.add(grey(90, {4, 1}), {0, 1, 4, 1}, 1.0);
  EXPECT_EQ(light.result().at<cv::Vec3b>(0, 0)[0], 0);
  EXPECT_EQ(light.result().at<cv::Vec3b>(1, 0)[0], 90);
}

TEST(LinearAccumulator, IsDarkAfterClear) {
  LinearAccumulator light(kSize);
  light.add(grey(90), kWhole, 1.0);
  light.clear();
  EXPECT_EQ(light.result().at<cv::Vec3b>(1, 1)[0], 0);
}

}  // namespace linear_accumulator_test
}  // namespace synthetic_dataset::render

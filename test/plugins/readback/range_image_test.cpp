#include "plugins/readback/range_image.h"

#include <cmath>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::formats {
namespace range_image_test {

const cv::Vec3b kRed{0, 0, 255};
const cv::Vec3b kNothing{0, 0, 0};

class RangeImage : public testing::Test {
 protected:
  void add(double azimuth, double elevation, double range, std::uint16_t ring = 0,
           std::uint16_t number = 0) {
    LabelledCloud::Point& point = cloud_.points.emplace_back();
    point.position_S = Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                       std::cos(elevation) * std::sin(azimuth), std::sin(elevation))
                           .cast<float>() *
                       static_cast<float>(range);
    point.ring = ring;
    point.number = number;
  }

  [[nodiscard]] RangeImages made(const cv::Size& size) const {
    return rangeImages(cloud_, {{1, {cv::Scalar(0, 0, 255), false}}}, size);
  }

  LabelledCloud cloud_;
};

TEST_F(RangeImage, HasWhatIsLeftOnTheLeftAndWhatIsHighAbove) {
  add(0.5, 0.2, 10.0, 0, 1);
  add(-0.5, -0.2, 10.0);
  const RangeImages images = made({11, 7});
  EXPECT_EQ(images.labels.at<cv::Vec3b>(0, 0), kRed);
  EXPECT_NE(images.labels.at<cv::Vec3b>(6, 10), kNothing);
  EXPECT_EQ(images.labels.at<cv::Vec3b>(0, 10), kNothing);
  EXPECT_NEAR(images.left, 0.5, 1e-6);
  EXPECT_NEAR(images.right, -0.5, 1e-6);
}

TEST_F(RangeImage, HasARowForEachRingTheHighestFirst) {
  cloud_.has_rings = true;
  add(0.5, -0.2, 10.0, 0);
  add(0.4, 0.2, 10.0, 1, 1);
  add(-0.5, -0.2, 10.0, 0);
  const RangeImages images = made({11, 8});
  for (int row = 0; row < 8; ++row) {
    EXPECT_EQ(images.labels.at<cv::Vec3b>(row, 1) == kRed, row < 4) << row;
  }
}

TEST_F(RangeImage, IsBrighterWhereThingsAreNear) {
  for (int i = 0; i <= 10; ++i) add(0.5 - 0.1 * i, 0.0, 2.0 + i);
  const cv::Mat ranges = made({11, 1}).ranges;
  const auto brightness = [&](int column) {
    const auto c = ranges.at<cv::Vec3b>(0, column);
    return c[0] + c[1] + c[2];
  };
  EXPECT_GT(brightness(0), brightness(5));
  EXPECT_GT(brightness(5), brightness(10));
}

TEST_F(RangeImage, ShowsTheNearestOfSeveral) {
  add(0.5, 0.0, 5.0);
  add(0.0, 0.0, 9.0);
  add(0.0, 0.0, 3.0, 0, 1);
  add(0.0, 0.0, 7.0);
  add(-0.5, 0.0, 5.0);
  EXPECT_EQ(made({11, 1}).labels.at<cv::Vec3b>(0, 5), kRed);
}

TEST_F(RangeImage, OfNothingIsBlack) {
  EXPECT_EQ(cv::countNonZero(made({11, 3}).ranges.reshape(1)), 0);
}

}  // namespace range_image_test
}  // namespace synthetic_dataset::formats

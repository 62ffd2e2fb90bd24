#include "plugins/readback/cloud_from_above.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset::formats {
namespace cloud_from_above_test {

constexpr int kSize = 400;  // [px]

/// A square of 10 m around the scanner, and one red point.
class CloudFromAboveTest : public testing::Test {
 protected:
  CloudFromAboveTest() {
    for (const float x : {-5.0F, 5.0F}) {
      for (const float y : {-5.0F, 5.0F}) add(x, y, 0);
    }
  }

  void add(float x, float y, std::uint16_t number) {
    LabelledCloud::Point& point = cloud_.points.emplace_back();
    point.position_S = {x, y, 0.0F};
    point.number = number;
  }

  /// The mean place of the red pixels.
  [[nodiscard]] cv::Point2d redPlace() const {
    const cv::Mat picture = cloudFromAbove(cloud_, {{1, {kRed, false}}}, kSize).picture;
    cv::Mat red;
    cv::inRange(picture, kRed, kRed, red);
    std::vector<cv::Point> places;
    cv::findNonZero(red, places);
    EXPECT_FALSE(places.empty());
    cv::Point2d sum;
    for (const cv::Point& each : places) sum += cv::Point2d(each);
    return sum / static_cast<double>(places.size());
  }

  const cv::Scalar kRed{0, 0, 255};
  LabelledCloud cloud_;
};

TEST_F(CloudFromAboveTest, HasWhatIsAheadAboveTheScannerAndWhatIsLeftOnItsLeft) {
  add(3.0F, 2.0F, 1);
  const cv::Point2d place = redPlace();
  // 5 m and a margin of 8 % are half of the picture.
  const double scale = 0.5 * kSize / (1.08 * 5.0);
  EXPECT_NEAR(place.x, 0.5 * kSize - 2.0 * scale, 2.0);
  EXPECT_NEAR(place.y, 0.5 * kSize - 3.0 * scale, 2.0);
}

TEST_F(CloudFromAboveTest, HasAGridOfARoundLength) {
  EXPECT_DOUBLE_EQ(cloudFromAbove(cloud_, {}, kSize).grid, 2.0);
}

TEST_F(CloudFromAboveTest, OutlinesBoxesInTheColourOfTheirClass) {
  cloud_.classes = {{1, "rover"}};
  cloud_.objects[1] = {"rover", "rover 1", Cuboid{{1.0, 1.0, 0.0}, {2.0, 2.0, 1.0}}.corners()};
  const cv::Point2d place = redPlace();
  const double scale = 0.5 * kSize / (1.08 * 5.0);
  EXPECT_LT(place.x, 0.5 * kSize - 0.9 * scale);
  EXPECT_LT(place.y, 0.5 * kSize - 0.9 * scale);
}

TEST_F(CloudFromAboveTest, OfNothingIsTheScannerAlone) {
  EXPECT_EQ(cloudFromAbove({}, {}, kSize).picture.size(), cv::Size(kSize, kSize));
}

TEST(MetresText, HasNoZerosAtItsEnd) {
  EXPECT_EQ(metresText(20.0), "20");
  EXPECT_EQ(metresText(0.5), "0.5");
  EXPECT_EQ(metresText(-1e-9), "0");
}

}  // namespace cloud_from_above_test
}  // namespace synthetic_dataset::formats

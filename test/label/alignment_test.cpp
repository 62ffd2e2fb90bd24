#include "label/alignment.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::label {
namespace alignment_test {

using ::testing::Eq;

/// A red square on grey.
cv::Mat picture() {
  cv::Mat image(80, 120, CV_8UC3, cv::Scalar(90, 90, 90));
  image(cv::Rect(40, 20, 30, 30)).setTo(cv::Scalar(20, 30, 200));
  return image;
}

/// The square's mask, shifted to the right [px].
Mask square(int right) {
  cv::Mat mask(80, 120, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(40 + right, 20, 30, 30)).setTo(255);
  return Mask(mask);
}

double scoreOf(const Mask& mask) { return alignmentOf(mask, smoothed(picture())).score().value(); }

TEST(Alignment, IsOneOnTheEdgesOfThePicture) { EXPECT_EQ(scoreOf(square(0)), 1.0); }

TEST(Alignment, FallsWithTheDistanceFromTheEdges) {
  EXPECT_LT(scoreOf(square(1)), 0.95);
  EXPECT_LT(scoreOf(square(2)), scoreOf(square(1)));
  EXPECT_LT(scoreOf(square(4)), scoreOf(square(2)));
  // Two of the four sides still lie on the square's, except for the part past its corner.
  EXPECT_NEAR(scoreOf(square(5)), 0.5, 0.1);
}

TEST(Alignment, IsUnknownWhereThePictureIsFlat) {
  const cv::Mat flat(80, 120, CV_8UC3, cv::Scalar(90, 90, 90));
  EXPECT_THAT(alignmentOf(square(0), smoothed(flat)).score(), Eq(std::nullopt));
}

TEST(Alignment, KnowsNothingOfTheImagesBorder) {
  cv::Mat image = picture();
  image.setTo(cv::Scalar(90, 90, 90));
  image(cv::Rect(0, 20, 30, 30)).setTo(cv::Scalar(20, 30, 200));
  cv::Mat mask(80, 120, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(0, 20, 30, 30)).setTo(255);
  EXPECT_EQ(alignmentOf(Mask(mask), smoothed(image)).score().value(), 1.0)
      << "where the object leaves the image there is no edge to meet";
}

}  // namespace alignment_test
}  // namespace synthetic_dataset::label

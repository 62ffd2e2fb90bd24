#include "synthetic_dataset/mask.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace mask_test {

/// Pixel by pixel.
cv::Rect slowBounds(const cv::Mat& mask) {
  cv::Rect bounds;
  for (int row = 0; row < mask.rows; ++row) {
    for (int column = 0; column < mask.cols; ++column) {
      if (mask.at<uchar>(row, column) != 0) bounds |= cv::Rect(column, row, 1, 1);
    }
  }
  return bounds;
}

TEST(MaskBounds, AreEmptyWhereNothingIs) {
  EXPECT_TRUE(maskBounds(cv::Mat()).empty());
  EXPECT_TRUE(maskBounds(cv::Mat::zeros(7, 33, CV_8UC1)).empty());
}

TEST(MaskBounds, AreThoseOfAllPixelsOfMasksOfAnyWidthAndPlace) {
  std::mt19937 random(3);
  const auto upTo = [&](int most) { return static_cast<int>(random() % (most + 1)); };
  for (int trial = 0; trial < 20000; ++trial) {
    cv::Mat image = cv::Mat::zeros(12, 40, CV_8UC1);
    const cv::Rect part(upTo(8), upTo(3), 1 + upTo(31), 1 + upTo(8));
    cv::Mat mask = image(part);
    for (int pixel = upTo(4); pixel > 0; --pixel) {
      mask.at<uchar>(upTo(part.height - 1), upTo(part.width - 1)) = trial % 2 == 0 ? 255 : 1;
    }
    ASSERT_EQ(maskBounds(mask), slowBounds(mask)) << mask;
    // Pixels outside the part do not count.
    cv::Mat rest = cv::Mat(image.size(), CV_8UC1, cv::Scalar(255));
    mask.copyTo(rest(part));
    ASSERT_EQ(maskBounds(rest(part)), slowBounds(mask)) << mask;
  }
}

/// An image of 8 x 6 pixels with a bar from (3, 2) to (5, 2).
cv::Mat bar() {
  cv::Mat image = cv::Mat::zeros(6, 8, CV_8UC1);
  image(cv::Rect(3, 2, 3, 1)).setTo(255);
  return image;
}

TEST(Mask, IsCutToItsPixels) {
  const Mask mask(bar());
  EXPECT_EQ(mask.bounds(), cv::Rect(3, 2, 3, 1));
  EXPECT_EQ(mask.offset(), cv::Point(3, 2));
  EXPECT_EQ(mask.pixels().size(), cv::Size(3, 1));
  EXPECT_EQ(mask.imageSize(), cv::Size(8, 6));
  EXPECT_EQ(mask.count(), 3);
}

TEST(Mask, TellsWhichPixelsOfTheImageAreOnIt) {
  const Mask mask(bar());
  EXPECT_TRUE(mask.at({3, 2}));
  EXPECT_FALSE(mask.at({2, 2}));
  EXPECT_FALSE(mask.at({3, 3}));
  EXPECT_FALSE(mask.at({-1, 99}));
}

TEST(Mask, MakesTheWholeImageAgain) {
  EXPECT_EQ(cv::norm(Mask(bar()).whole(), bar(), cv::NORM_INF), 0.0);
}

TEST(Mask, IsTheSameMadeOfAPart) {
  const cv::Rect part(2, 1, 5, 4);
  const Mask mask(bar()(part), part.tl(), {8, 6});
  EXPECT_EQ(cv::norm(mask.whole(), bar(), cv::NORM_INF), 0.0);
}

TEST(Mask, WithoutPixelsIsEmptyAndStillOfAnImage) {
  for (const Mask& mask : {Mask(cv::Size(8, 6)), Mask(cv::Mat::zeros(6, 8, CV_8UC1))}) {
    EXPECT_TRUE(mask.empty());
    EXPECT_EQ(mask.count(), 0);
    EXPECT_FALSE(mask.at({0, 0}));
    EXPECT_EQ(cv::norm(mask.whole(), cv::Mat::zeros(6, 8, CV_8UC1), cv::NORM_INF), 0.0);
  }
}

TEST(Mask, SharesPixelsWithCopiesAndKeepsNoMuchLargerImage) {
  const cv::Mat image = bar();
  const Mask small(image);
  const Mask copy = small;
  EXPECT_EQ(copy.pixels().data, small.pixels().data);
  EXPECT_NE(small.pixels().data, image.ptr(2) + 3) << "three pixels would keep all of the image";
  const cv::Mat full(6, 8, CV_8UC1, cv::Scalar(255));
  EXPECT_EQ(Mask(full).pixels().data, full.data);
}

TEST(Mask, RefusesPixelsOutsideOfItsImageAndOfOtherTypes) {
  EXPECT_THROW(Mask(bar(), {3, 0}, {8, 6}), Error);
  EXPECT_NO_THROW(Mask(bar(), {2, 0}, {8, 6}));
  EXPECT_THROW(Mask(cv::Mat::ones(6, 8, CV_16UC1)), Error);
}

}  // namespace mask_test
}  // namespace synthetic_dataset

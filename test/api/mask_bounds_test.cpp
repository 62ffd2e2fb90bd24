#include "synthetic_dataset/mask_bounds.h"

#include <random>

#include <gtest/gtest.h>

namespace synthetic_dataset {
namespace {

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
    // What is beside the part does not count.
    cv::Mat rest = cv::Mat(image.size(), CV_8UC1, cv::Scalar(255));
    mask.copyTo(rest(part));
    ASSERT_EQ(maskBounds(rest(part)), slowBounds(mask)) << mask;
  }
}

}  // namespace
}  // namespace synthetic_dataset

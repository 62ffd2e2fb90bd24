#include "render/parts/picture_pyramid.h"

#include <limits>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace picture_pyramid_test {

constexpr int kSide = 8;

/// Red grows from column to column, green from row to row.
world::Texture ramps() {
  world::Texture texture;
  texture.pixels = cv::Mat(kSide, kSide, CV_8UC4);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      texture.pixels.at<cv::Vec4b>(row, column) = cv::Vec4b(
          51, static_cast<unsigned char>(20 * row), static_cast<unsigned char>(20 * column), 255);
    }
  }
  return texture;
}

class PicturePyramidTest : public testing::Test {
 protected:
  /// A sample of the largest level: the steps are small.
  [[nodiscard]] Eigen::Vector4f at(float x, float y) const {
    return 255.0F * pyramid_.mean({x, y}, {1e-3F, 0.0F}, {0.0F, 1e-3F});
  }

  PicturePyramid pyramid_{ramps(), PixelMeaning::kData};
};

TEST_F(PicturePyramidTest, IsATexelInItsMiddleAndAMixBetween) {
  EXPECT_NEAR(at(2.5F / kSide, 5.5F / kSide).x(), 40.0F, 0.1F);
  EXPECT_NEAR(at(2.5F / kSide, 5.5F / kSide).y(), 100.0F, 0.1F);
  EXPECT_NEAR(at(2.5F / kSide, 5.5F / kSide).z(), 51.0F, 0.1F);
  EXPECT_NEAR(at(2.75F / kSide, 5.0F / kSide).x(), 45.0F, 0.1F);
  EXPECT_NEAR(at(2.75F / kSide, 5.0F / kSide).y(), 90.0F, 0.1F);
}

TEST_F(PicturePyramidTest, GoesOnAtTheOppositeEdge) {
  EXPECT_NEAR(at(0.0F, 0.5F / kSide).x(), 70.0F, 0.5F);  // between 140 and 0
  EXPECT_NEAR(at(-1.0F + 2.5F / kSide, 3.0F + 5.5F / kSide).x(), 40.0F, 0.1F);
  EXPECT_NEAR(at(-1.0F + 2.5F / kSide, 3.0F + 5.5F / kSide).y(), 100.0F, 0.1F);
}

TEST_F(PicturePyramidTest, IsTheMeanOverAPixel) {
  const Eigen::Vector4f all = 255.0F * pyramid_.mean({0.5F, 0.5F}, {1.0F, 0.0F}, {0.0F, 1.0F});
  EXPECT_NEAR(all.x(), 70.0F, 2.0F);
  EXPECT_NEAR(all.y(), 70.0F, 2.0F);
  // Wide and low: over some columns, in one row.
  const Eigen::Vector4f wide =
      255.0F * pyramid_.mean({0.5F, 2.5F / kSide}, {0.5F, 0.0F}, {0.0F, 1e-3F});
  EXPECT_NEAR(wide.x(), 70.0F, 0.5F);
  EXPECT_NEAR(wide.y(), 40.0F, 0.5F);
}

TEST_F(PicturePyramidTest, IsSomeColourWhereNoPlaceIsKnown) {
  for (const float odd :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30F}) {
    const Eigen::Vector2f nowhere(odd, odd);
    EXPECT_TRUE(pyramid_.mean(nowhere, nowhere, nowhere).allFinite()) << odd;
    EXPECT_TRUE(pyramid_.sample(nowhere, nowhere, nowhere).allFinite()) << odd;
  }
}

}  // namespace picture_pyramid_test
}  // namespace synthetic_dataset::render

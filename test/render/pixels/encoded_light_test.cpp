#include "render/pixels/encoded_light.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/half_numbers.h"

namespace synthetic_dataset::render {
namespace encoded_light_test {

using test::halfBits;
using test::halfNumber;

cv::Mat pixel(float encoded) {
  const auto half = halfBits(encoded);
  return {1, 1, CV_16UC4, cv::Scalar(half, halfBits(0.5F * encoded), half, 7)};
}

/// The red channel after exposing.
float exposed(float encoded, float exposure) {
  cv::Mat light = pixel(encoded);
  exposeEncoded(light, exposure, {{0, 0, 1, 1}});
  EXPECT_EQ(light.at<cv::Vec4w>(0)[3], 7) << "what is no colour stays";
  return halfNumber(light.at<cv::Vec4w>(0)[0]);
}

double decoded(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

TEST(EncodedLight, BecomesLinearByTheTransferFunctionOfSrgb) {
  for (float encoded = 0.02F; encoded < 1.0F; encoded += 0.013F) {
    const double there = halfNumber(halfBits(encoded));
    EXPECT_NEAR(exposed(encoded, 1.0F), decoded(there), 6e-4 * decoded(there)) << encoded;
  }
  EXPECT_EQ(exposed(0.0F, 1.0F), 0.0F);
  EXPECT_EQ(exposed(1.0F, 1.0F), 1.0F);
}

TEST(EncodedLight, IsExposedAndNeverMoreThanWhite) {
  EXPECT_NEAR(exposed(0.5F, 2.0F), 2.0 * decoded(0.5), 1e-3);
  EXPECT_EQ(exposed(0.9F, 2.0F), 1.0F);
  EXPECT_EQ(exposed(3.0F, 1.0F), 1.0F);
}

TEST(EncodedLight, OfMoreThanOneShowsWhereTheExposureIsShort) {
  EXPECT_EQ(brightestEncoded(1.0F), 1.0F);
  EXPECT_EQ(brightestEncoded(3.0F), 1.0F);
  EXPECT_NEAR(decoded(brightestEncoded(0.25F)), 4.0, 1e-4);
  EXPECT_NEAR(exposed(1.5F, 0.25F), 0.25 * decoded(1.5), 1e-3);
}

TEST(EncodedLight, StaysBesideTheRegions) {
  cv::Mat light(1, 2, CV_16UC4);
  pixel(0.5F).copyTo(light.col(0));
  pixel(0.5F).copyTo(light.col(1));
  exposeEncoded(light, 1.0F, {{1, 0, 1, 1}});
  EXPECT_EQ(light.at<cv::Vec4w>(0)[0], halfBits(0.5F));
  EXPECT_NE(light.at<cv::Vec4w>(1)[0], halfBits(0.5F));
}

}  // namespace encoded_light_test
}  // namespace synthetic_dataset::render

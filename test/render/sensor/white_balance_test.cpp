#include "render/sensor/white_balance.h"

#include <gtest/gtest.h>

#include "render/sensor/sensor_options.h"

namespace synthetic_dataset::render {
namespace white_balance_test {

TEST(WhiteBalance, IsNeutralForTheLightOfThePictures) {
  const cv::Vec3f gains = whiteBalanceGains(kNeutralWhite);
  for (int channel = 0; channel < 3; ++channel) EXPECT_FLOAT_EQ(gains[channel], 1.0F);
}

// CIE's standard illuminant A is a black body of 2856 K: X 109.85, Y 100, Z 35.58. A camera that is
// set to it shows its light as white, except that a black body of 6500 K is redder than D65.
TEST(WhiteBalance, OfABulbShowsABulbsLightAsWhite) {
  const cv::Vec3d illuminant(0.2333, 0.8262, 1.8452);  // linear sRGB: blue, green, red
  const cv::Vec3f gains = whiteBalanceGains(2856.0);
  const double green = illuminant[1] * gains[1];
  EXPECT_NEAR(illuminant[0] * gains[0] / green, 1.0, 0.07);
  EXPECT_NEAR(illuminant[2] * gains[2] / green, 1.0, 0.07);
}

TEST(WhiteBalance, GoesFromBlueToRed) {
  double before = 0.0;
  for (double kelvin : {kReddestLight, 3000.0, 3999.0, 4001.0, 6500.0, 10000.0, kBluestLight}) {
    const cv::Vec3f gains = whiteBalanceGains(kelvin);
    EXPECT_GT(gains[2] / gains[0], before) << kelvin;
    before = gains[2] / gains[0];
  }
}

}  // namespace white_balance_test
}  // namespace synthetic_dataset::render

#include <cmath>

#include <gtest/gtest.h>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace srgb_test {

TEST(Srgb, ThereAndBackIsTheSame) {
  for (int value = 0; value < 256; ++value) {
    const auto encoded = static_cast<std::uint8_t>(value);
    EXPECT_EQ(srgbFromLinear(linearFromSrgb()[encoded]), encoded);
  }
}

TEST(Srgb, AFifthOfTheLightLooksHalfAsBright) {
  EXPECT_NEAR(linearFromSrgb()[128], 0.2159, 1e-4);  // published: 21.59 %
  EXPECT_EQ(srgbFromLinear(0.5F), 188);
}

TEST(Srgb, TheNearestValueIsTaken) {
  for (int i = 0; i <= 20000; ++i) {
    const double light = i / 20000.0;
    const double encoded =
        light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    const double distance = std::abs(srgbFromLinear(static_cast<float>(light)) - 255.0 * encoded);
    EXPECT_LE(distance, 0.5 + 1e-3) << light;
  }
}

TEST(Srgb, WhatIsBeyondTheRangeIsClipped) {
  EXPECT_EQ(srgbFromLinear(-1.0F), 0);
  EXPECT_EQ(srgbFromLinear(7.0F), 255);
}

}  // namespace srgb_test
}  // namespace synthetic_dataset::render

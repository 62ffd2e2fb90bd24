#include "render/pixels/lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/half_numbers.h"
#include "render/pixels/lane_images.h"

namespace synthetic_dataset::render {
namespace lanes_test {

std::array<float, kLaneCount> stored(const Lanes& numbers) {
  std::array<float, kLaneCount> result{};
  cv::v_store(result.data(), numbers);
  return result;
}

TEST(Lanes, HaveTheExponentialOfEach) {
  for (float power = -87.0F; power <= 87.0F; power += 0.375F) {
    const auto result = stored(exponential(Lanes(power, power / 3.0F, 0.0F, -power)));
    EXPECT_NEAR(result[0] / std::exp(double{power}), 1.0, 3e-7) << power;
    EXPECT_NEAR(result[1] / std::exp(double{power / 3.0F}), 1.0, 3e-7) << power;
    EXPECT_EQ(result[2], 1.0F);
    EXPECT_NEAR(result[3] / std::exp(-double{power}), 1.0, 3e-7) << power;
  }
  EXPECT_LT(stored(exponential(lanes(-1000.0F)))[0], 1e-37F);
}

TEST(Lanes, HaveTheLogarithmOfEach) {
  for (float number = 1e-6F; number < 1e6F; number *= 1.37F) {
    const auto result = stored(logarithm(Lanes(number, 1.0F, 0.5F, 1e-30F)));
    EXPECT_NEAR(result[0], std::log(double{number}), 3e-7 * std::max(1.0F, std::abs(result[0])));
    EXPECT_EQ(result[1], 0.0F);
    EXPECT_NEAR(result[2], std::log(0.5), 1e-7);
    EXPECT_NEAR(result[3], std::log(1e-30), 1e-5);
  }
}

TEST(Lanes, HavePowers) {
  for (float base = 0.01F; base <= 1.0F; base += 0.0075F) {
    const auto result = stored(power(lanes(base), Lanes(1.0F, 1.5F, 12.5F, 128.0F)));
    EXPECT_NEAR(result[0], base, 1e-6);
    EXPECT_NEAR(result[1], std::pow(double{base}, 1.5), 1e-6);
    EXPECT_NEAR(result[2], std::pow(double{base}, 12.5), 1e-5);
    EXPECT_NEAR(result[3], std::pow(double{base}, 128.0), 1e-4);
  }
  EXPECT_EQ(stored(power(lanes(0.0F), lanes(1.0F)))[0], 0.0F);
}

TEST(Lanes, AreStoredAsNumbersOf16BitsAsOpenCvHasThem) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> exponent(-13.9F, 15.9F);
  for (int i = 0; i < 2000; ++i) {
    const std::array<float, 3> numbers = {std::exp2(exponent(random)), std::exp2(exponent(random)),
                                          i % 2 == 0 ? 0.0F : 1.0F};
    std::array<std::uint16_t, 16> bits{};
    storeHalves(bits.data(), {lanes(numbers[0]), lanes(numbers[1]), lanes(numbers[2])});
    for (std::size_t k = 0; k < bits.size(); ++k) {
      const float number = k % 4 == 3 ? 1.0F : numbers[k % 4];
      ASSERT_EQ(bits[k], test::halfBits(number)) << number;
    }
  }
}

TEST(Lanes, AreLoadedFromNumbersOf16Bits) {
  for (const float number : {0.0F, 1.0F, -1.0F, 0.333F, -0.0625F, 65504.0F, 6.2e-5F, 6e-5F}) {
    std::array<std::uint16_t, 16> bits{};
    for (std::size_t k = 0; k < bits.size(); ++k) {
      bits[k] = test::halfBits(k % 4 == 1 ? number : 0.5F);
    }
    const PixelLanes pixels = loadHalves(bits.data());
    const float wanted =
        std::abs(number) < 6.1e-5F ? 0.0F : test::halfNumber(test::halfBits(number));
    EXPECT_EQ(stored(pixels.xyz.y)[3], wanted);
    EXPECT_EQ(stored(pixels.w)[0], 0.5F);
  }
}

TEST(LaneImages, AreWideEnough) {
  const cv::Mat narrow = (cv::Mat_<int>(2, 2) << 1, 2, 3, 4);
  const cv::Mat wide = (cv::Mat_<int>(2, 4) << 1, 2, 2, 2, 3, 4, 4, 4);
  EXPECT_EQ(cv::norm(widened(narrow), wide, cv::NORM_INF), 0.0);
  EXPECT_EQ(widened(wide).data, wide.data);
  EXPECT_EQ(firstLane(4, 10), 4);
  EXPECT_EQ(firstLane(8, 10), 6);
}

}  // namespace lanes_test
}  // namespace synthetic_dataset::render

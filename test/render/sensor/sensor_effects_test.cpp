#include "render/sensor/sensor_effects.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace sensor_effects_test {

constexpr int kSide = 200;

cv::Mat grey(int value) { return {kSide, kSide, CV_8UC3, cv::Scalar::all(value)}; }

/// Mean and standard deviation over all values of a picture.
std::pair<double, double> moments(const cv::Mat& picture) {
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(picture.reshape(1), mean, deviation);
  return {mean[0], deviation[0]};
}

bool same(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0.0; }

TEST(SensorEffects, NoneLeaveThePictureItself) {
  const cv::Mat picture = grey(100);
  EXPECT_EQ(applyEffects(picture, {}, 1).data, picture.data);
}

TEST(SensorEffects, AStopDoublesTheLight) {
  SensorEffects effects;
  effects.exposure = 1.0;
  EXPECT_EQ(gainOf(effects), 2.0);
  EXPECT_EQ(gainOf({}), 1.0);
}

TEST(SensorEffects, GaussianNoiseHasItsMeanAndDeviation) {
  SensorEffects effects;
  effects.noise_mean = 0.02;
  effects.noise_stddev = 0.03;
  const auto [mean, deviation] = moments(applyEffects(grey(100), effects, 1));
  const double n = 3.0 * kSide * kSide;
  EXPECT_NEAR(mean, 100 + 0.02 * 255, 4 * 0.03 * 255 / std::sqrt(n));
  // Rounding to whole values adds a variance of 1 / 12.
  EXPECT_NEAR(deviation, std::sqrt(std::pow(0.03 * 255, 2) + 1.0 / 12), 0.1);
}

TEST(SensorEffects, TheSameSeedGivesTheSameNoise) {
  SensorEffects effects;
  effects.noise_stddev = 0.03;
  effects.full_well = 500;
  const cv::Mat first = applyEffects(grey(100), effects, 1);
  EXPECT_TRUE(same(first, applyEffects(grey(100), effects, 1)));
  EXPECT_FALSE(same(first, applyEffects(grey(100), effects, 2)));
}

TEST(SensorEffects, ShotNoiseGrowsAsTheRootOfTheLight) {
  SensorEffects effects;
  effects.full_well = 1000;
  for (const int value : {80, 160, 220}) {
    const cv::Mat noisy = applyEffects(grey(value), effects, 3);
    double sum = 0.0;
    double squares = 0.0;
    for (const cv::Vec3b& pixel : cv::Mat_<cv::Vec3b>(noisy)) {
      for (int channel = 0; channel < 3; ++channel) {
        const double light = linearFromSrgb()[pixel[channel]];
        sum += light;
        squares += light * light;
      }
    }
    const double n = 3.0 * kSide * kSide;
    const double light = linearFromSrgb()[static_cast<std::size_t>(value)];
    const double variance = squares / n - (sum / n) * (sum / n);
    EXPECT_NEAR(sum / n, light, 0.002) << value;
    EXPECT_NEAR(variance, light / 1000, 0.03 * light / 1000) << value;
  }
}

TEST(SensorEffects, VignettingDarkensTheCornersByItsStrength) {
  SensorEffects effects;
  effects.vignetting = 0.5;
  const cv::Mat picture = applyEffects(grey(255), effects, 1);
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0)[0], 188);  // half the light
  EXPECT_EQ(picture.at<cv::Vec3b>(kSide / 2, kSide / 2)[0], 255);
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0), picture.at<cv::Vec3b>(kSide - 1, kSide - 1));
}

TEST(SensorEffects, BlurSpreadsAPointByItsDeviation) {
  cv::Mat picture = grey(0);
  picture.at<cv::Vec3b>(kSide / 2, kSide / 2) = {255, 255, 255};
  SensorEffects effects;
  effects.blur = 1.5;
  const cv::Mat blurred = applyEffects(picture, effects, 1);
  // The light in the middle is that of a normalised Gaussian there: 1 / (2 pi sigma^2).
  const double centre = linearFromSrgb()[blurred.at<cv::Vec3b>(kSide / 2, kSide / 2)[0]];
  EXPECT_NEAR(centre, 1.0 / (2.0 * 3.14159265 * 1.5 * 1.5), 0.003);
}

TEST(SensorEffects, AWhiteBalanceForBlueLightReddensAndKeepsTheLuminance) {
  SensorEffects effects;
  effects.white_balance = 10000.0;
  const cv::Vec3b pixel = applyEffects(grey(120), effects, 1).at<cv::Vec3b>(3, 7);
  EXPECT_LT(pixel[0] + 10, pixel[1]);
  EXPECT_GT(pixel[2], pixel[1] + 10);
  const auto& linear = linearFromSrgb();
  EXPECT_NEAR(0.0722 * linear[pixel[0]] + 0.7152 * linear[pixel[1]] + 0.2126 * linear[pixel[2]],
              linear[120], 0.003);
}

TEST(SensorEffects, CompressionLeavesGreysAndBlursFineColours) {
  SensorEffects effects;
  effects.jpeg_quality = 50;
  EXPECT_TRUE(same(applyEffects(grey(128), effects, 1), grey(128)));
  cv::Mat stripes = grey(0);
  for (int u = 0; u < kSide; u += 2) stripes.col(u) = cv::Scalar(0, 0, 255);
  const cv::Mat before = stripes.clone();
  const cv::Mat after = applyEffects(stripes, effects, 1);
  EXPECT_TRUE(same(stripes, before));
  // Colours are halved in resolution: red runs into the black between.
  EXPECT_LT(after.at<cv::Vec3b>(100, 100)[2], 230);
  EXPECT_GT(after.at<cv::Vec3b>(100, 101)[2], 25);
}

}  // namespace sensor_effects_test
}  // namespace synthetic_dataset::render

#include "randomize/appearance/natural_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::randomize {
namespace natural_picture_test {

constexpr std::uint64_t kPictures = 60;

NaturalPicture textureOf(std::uint64_t seed, int side = 256) {
  base::RandomSource random(seed);
  return drawNaturalTexture(random, side);
}

NaturalPicture backgroundOf(std::uint64_t seed) {
  base::RandomSource random(seed);
  return drawNaturalPicture(random, 320, 256);
}

/// The mean difference between the channels of two columns.
double stepBetween(const cv::Mat& picture, int left, int right) {
  return cv::norm(picture.col(left), picture.col(right), cv::NORM_L1) / (3.0 * picture.rows);
}

cv::Mat greyOf(const cv::Mat& picture) {
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGRA2GRAY);
  grey.convertTo(grey, CV_64F);
  return grey;
}

/// The exponent of the frequency that the power spectrum follows: the slope of a line through its
/// means over rings, with both axes logarithmic.
double spectralSlope(const cv::Mat& picture) {
  constexpr int kSide = 256;
  cv::Mat grey = greyOf(picture)(cv::Rect(0, 0, kSide, kSide));
  cv::Mat window;
  cv::createHanningWindow(window, {kSide, kSide}, CV_64F);
  grey = (grey - cv::mean(grey)[0]).mul(window);
  cv::Mat spectrum;
  cv::dft(grey, spectrum, cv::DFT_COMPLEX_OUTPUT);
  std::map<int, std::pair<double, int>> rings;  // half octaves
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double frequency = std::hypot(std::min(x, kSide - x), std::min(y, kSide - y));
      if (frequency < 3.0 || frequency > 60.0) continue;
      const auto& value = spectrum.at<cv::Vec2d>(y, x);
      auto& ring = rings[static_cast<int>(2.0 * std::log2(frequency))];
      ring.first += value.dot(value);
      ++ring.second;
    }
  }
  double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  for (const auto& [index, ring] : rings) {
    const double x = 0.5 * (index + 0.5) * std::log(2.0);
    const double y = std::log(ring.first / ring.second);
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  const auto count = static_cast<double>(rings.size());
  return (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
}

TEST(NaturalPicture, HasKindsThatAllCome) {
  std::map<std::string, int> textures;
  std::map<std::string, int> backgrounds;
  for (std::uint64_t seed = 0; seed < 3 * kPictures; ++seed) {
    ++textures[textureOf(seed).kind];
    ++backgrounds[backgroundOf(seed).kind];
  }
  EXPECT_EQ(textures.size(), 15U);
  EXPECT_EQ(backgrounds.size(), 8U);
  for (const auto& [kind, count] : textures) EXPECT_GE(count, 3) << kind;
  for (const auto& [kind, count] : backgrounds) EXPECT_GE(count, 6) << kind;
}

TEST(NaturalPicture, IsOpaqueAndOfTheSizeThatIsAskedFor) {
  for (std::uint64_t seed = 0; seed < kPictures; ++seed) {
    base::RandomSource random(seed);
    const cv::Mat background = drawNaturalPicture(random, 200, 77).pixels;
    EXPECT_EQ(background.size(), cv::Size(200, 77));
    const cv::Mat texture = textureOf(seed, seed % 2 == 0 ? 256 : 512).pixels;
    EXPECT_EQ(texture.size(), (seed % 2 == 0 ? cv::Size(256, 256) : cv::Size(512, 512)));
    for (const cv::Mat& picture : {background, texture}) {
      ASSERT_EQ(picture.type(), CV_8UC4);
      cv::Mat alpha;
      cv::extractChannel(picture, alpha, 3);
      EXPECT_EQ(cv::countNonZero(alpha != 255), 0) << seed;
    }
  }
}

TEST(NaturalPicture, IsTheSameOfTheSameNumbersAndAnotherOfOthers) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto difference = [](const NaturalPicture& first, const NaturalPicture& second) {
      return cv::norm(first.pixels, second.pixels, cv::NORM_INF);
    };
    EXPECT_EQ(difference(textureOf(seed), textureOf(seed)), 0.0);
    EXPECT_EQ(difference(backgroundOf(seed), backgroundOf(seed)), 0.0);
    EXPECT_GT(difference(textureOf(seed), textureOf(seed + 1)), 20.0);
    EXPECT_GT(difference(backgroundOf(seed), backgroundOf(seed + 1)), 20.0);
  }
}

/// A texture changes no more across its border than somewhere inside.
TEST(NaturalPicture, RepeatsWithoutASeam) {
  for (std::uint64_t seed = 0; seed < 2 * kPictures; ++seed) {
    const NaturalPicture texture = textureOf(seed, seed % 2 == 0 ? 256 : 512);
    for (const cv::Mat& picture : {texture.pixels, cv::Mat(texture.pixels.t())}) {
      std::vector<double> inside;
      for (int i = 1; i < picture.cols; ++i) inside.push_back(stepBetween(picture, i - 1, i));
      std::sort(inside.begin(), inside.end());
      // Few columns have a step where cells meet.
      const double border = stepBetween(picture, picture.cols - 1, 0);
      const double usual = inside[inside.size() / 2];
      EXPECT_LE(border, std::max(1.4 * usual + 0.5, inside.back())) << texture.kind << ", " << seed;
      if (texture.kind == "concrete" || texture.kind == "brick" || texture.kind == "tiles" ||
          texture.kind == "wood" || texture.kind == "metal" || texture.kind == "cloth" ||
          texture.kind == "leaves") {
        continue;
      }
      EXPECT_LE(border, 1.5 * usual + 0.5) << texture.kind << ", " << seed;
    }
  }
}

/// The power of photographs falls off by about the square of the frequency: from 1.5 to 3 for
/// single ones (Tolhurst, Tadmor and Chao 1992, twice their exponents of the amplitude).
TEST(NaturalPicture, HasTheSpectrumOfPhotographs) {
  double sum = 0.0;
  int usual = 0;
  for (std::uint64_t seed = 0; seed < kPictures; ++seed) {
    const NaturalPicture picture = backgroundOf(seed);
    const double slope = spectralSlope(picture.pixels);
    EXPECT_LT(slope, -0.6) << picture.kind << ", " << seed;
    EXPECT_GT(slope, -4.2) << picture.kind << ", " << seed;
    usual += slope < -1.4 && slope > -3.0 ? 1 : 0;
    sum += slope;
  }
  EXPECT_NEAR(sum / kPictures, -2.1, 0.4);
  EXPECT_GT(usual, static_cast<int>(0.7 * kPictures));
}

TEST(NaturalPicture, IsNeitherBlackNorWhiteNorFlat) {
  for (std::uint64_t seed = 0; seed < kPictures; ++seed) {
    cv::Scalar mean;
    cv::Scalar deviation;
    const NaturalPicture background = backgroundOf(seed);
    cv::meanStdDev(greyOf(background.pixels), mean, deviation);
    EXPECT_GT(mean[0], 30.0) << background.kind << ", " << seed;
    EXPECT_LT(mean[0], 225.0) << background.kind << ", " << seed;
    EXPECT_GT(deviation[0], 12.0) << background.kind << ", " << seed;
    const NaturalPicture texture = textureOf(seed);
    cv::meanStdDev(greyOf(texture.pixels), mean, deviation);
    EXPECT_GT(mean[0], 12.0) << texture.kind << ", " << seed;
    EXPECT_LT(mean[0], 250.0) << texture.kind << ", " << seed;
    EXPECT_GT(deviation[0], 1.0) << texture.kind << ", " << seed;
  }
}

/// Mostly dull, of many tones, and vivid here and there.
TEST(NaturalPicture, HasTheColoursOfWhatIsAroundUs) {
  for (const bool is_texture : {true, false}) {
    std::vector<double> tones;
    std::vector<double> warmths;
    int dull = 0;
    double vivid = 0.0;
    for (std::uint64_t seed = 0; seed < kPictures; ++seed) {
      const cv::Mat picture = (is_texture ? textureOf(seed) : backgroundOf(seed)).pixels;
      const cv::Scalar mean = cv::mean(picture);
      tones.push_back(mean[1]);
      warmths.push_back(mean[2] - mean[0]);
      const auto [least, most] = std::minmax({mean[0], mean[1], mean[2]});
      dull += most - least < 0.35 * most ? 1 : 0;
      cv::Mat hsv;
      cv::cvtColor(picture, hsv, cv::COLOR_BGR2HSV);
      cv::Mat is_vivid;
      cv::inRange(hsv, cv::Scalar(0, 150, 110), cv::Scalar(180, 255, 255), is_vivid);
      vivid += static_cast<double>(cv::countNonZero(is_vivid)) /
               static_cast<double>(picture.total()) / kPictures;
    }
    const auto spread = [](const std::vector<double>& values) {
      cv::Scalar mean;
      cv::Scalar deviation;
      cv::meanStdDev(values, mean, deviation);
      return deviation[0];
    };
    EXPECT_GT(spread(tones), 15.0) << is_texture;
    EXPECT_GT(spread(warmths), 12.0) << is_texture;
    EXPECT_GT(dull, static_cast<int>(0.5 * kPictures)) << is_texture;
    EXPECT_GT(vivid, 0.005) << is_texture;
    EXPECT_LT(vivid, 0.15) << is_texture;
  }
}

}  // namespace natural_picture_test
}  // namespace synthetic_dataset::randomize

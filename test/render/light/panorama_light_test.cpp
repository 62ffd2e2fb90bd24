/// The light of panoramas, against sums over all of their pixels.

#include "render/light/panorama_light.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace panorama_light_test {

using Eigen::Vector3d;

PanoramaLight lightOf(const cv::Mat& pixels) {
  world::Texture picture;
  picture.pixels = pixels;
  return PanoramaLight(panoramaOf(picture));
}

cv::Mat plain(const cv::Scalar& pixel, int rows = 100) { return {rows, 2 * rows, CV_8UC4, pixel}; }

/// Blue in the upper half, brown in the lower, with two white rectangles: one towards +x, one near
/// the top.
cv::Mat scenery(int rows = 100) {
  cv::Mat pixels = plain({60, 90, 120, 255}, rows);
  pixels.rowRange(0, rows / 2).setTo(cv::Scalar(230, 170, 90, 255));
  pixels(cv::Rect(rows * 85 / 100, rows * 35 / 100, rows * 3 / 10, rows / 4))
      .setTo(cv::Scalar(255, 255, 255, 255));
  pixels(cv::Rect(rows / 5, rows * 8 / 100, rows / 2, rows / 8))
      .setTo(cv::Scalar(90, 200, 255, 255));
  return pixels;
}

Vector3d of(const Lanes3& light) {
  return {double{light.x.get0()}, double{light.y.get0()}, double{light.z.get0()}};
}

Lanes3 along(const Vector3d& direction) { return lanes(Eigen::Vector3f(direction.cast<float>())); }

Vector3d mirrored(const PanoramaLight& light, const Vector3d& direction, double roughness) {
  return of(light.mirrored(along(direction), lanes(static_cast<float>(roughness))));
}

Vector3d arriving(const PanoramaLight& light, const Vector3d& normal) {
  return of(light.above().arriving(along(normal)) + light.below().arriving(along(normal)));
}

Vector3d directionAt(const cv::Mat& pixels, double row, double column) {
  const double elevation = M_PI * (0.5 - (row + 0.5) / pixels.rows);
  // The middle is +x, and to its right is -y.
  const double azimuth = M_PI * (1.0 - 2.0 * (column + 0.5) / pixels.cols);
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

Vector3d linearOf(const cv::Vec4b& pixel) {
  const auto& linear = linearFromSrgb();
  return {linear[pixel[2]], linear[pixel[1]], linear[pixel[0]]};
}

/// The mean of all pixels, weighted by their directions.
template <class Weight>
Vector3d mean(const cv::Mat& pixels, const Weight& weight) {
  Vector3d sum = Vector3d::Zero();
  double all = 0.0;
  for (int row = 0; row < pixels.rows; ++row) {
    const double area = std::cos(M_PI * (0.5 - (row + 0.5) / pixels.rows));
    for (int column = 0; column < pixels.cols; ++column) {
      const double share = area * weight(directionAt(pixels, row, column));
      sum += share * linearOf(pixels.at<cv::Vec4b>(row, column));
      all += share;
    }
  }
  return sum / all;
}

Vector3d facedBy(const cv::Mat& pixels, const Vector3d& normal) {
  return mean(pixels, [&](const Vector3d& from) { return std::max(0.0, from.dot(normal)); });
}

/// The light through the GGX lobe of a surface that is seen head-on.
Vector3d throughLobe(const cv::Mat& pixels, const Vector3d& normal, double roughness) {
  const double a2 = std::pow(roughness, 4.0);
  return mean(pixels, [&](const Vector3d& from) {
    const double n_dot_l = std::max(0.0, from.dot(normal));
    const double n_dot_h = normal.dot((from + normal).normalized());
    const double bell = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
    return n_dot_l * a2 / (bell * bell);
  });
}

class Directions {
 public:
  Vector3d next() {
    return Vector3d(normally_(random_), normally_(random_), normally_(random_)).normalized();
  }

 private:
  std::mt19937 random_{5};
  std::normal_distribution<double> normally_;
};

TEST(PanoramaLight, ArrivesFromAllPixelsByTheirCosines) {
  const cv::Mat pixels = scenery();
  const PanoramaLight light = lightOf(pixels);
  Directions directions;
  double brightest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Vector3d normal = directions.next();
    const Vector3d expected = facedBy(pixels, normal);
    EXPECT_LT((arriving(light, normal) - expected).cwiseAbs().maxCoeff(), 0.005);
    brightest = std::max(brightest, expected.maxCoeff());
  }
  EXPECT_GT(brightest, 0.5);
}

TEST(PanoramaLight, OfOneColourIsThatColour) {
  const PanoramaLight white = lightOf(plain({255, 255, 255, 255}));
  Directions directions;
  for (int i = 0; i < 20; ++i) {
    const Vector3d way = directions.next();
    EXPECT_LT((arriving(white, way) - Vector3d::Ones()).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_LT((mirrored(white, way, i / 19.0) - Vector3d::Ones()).cwiseAbs().maxCoeff(), 1e-3);
  }
}

TEST(PanoramaLight, MayBeBrighterThanWhite) {
  const PanoramaLight bright = lightOf(cv::Mat(100, 200, CV_32FC4, cv::Scalar(2, 6, 40, 1)));
  const Vector3d colour(40, 6, 2);
  Directions directions;
  for (int i = 0; i < 20; ++i) {
    const Vector3d way = directions.next();
    EXPECT_LT((arriving(bright, way) - colour).cwiseAbs().maxCoeff(), 0.04);
    EXPECT_LT((mirrored(bright, way, i / 19.0) - colour).cwiseAbs().maxCoeff(), 0.04);
  }
}

/// As in panoramas of high dynamic range.
TEST(PanoramaLight, OfASunLightsNothingThatIsTurnedAway) {
  cv::Mat pixels(128, 256, CV_32FC4, cv::Scalar(0, 0, 0, 1));
  pixels.at<cv::Vec4f>(40, 70) = {0.0F, 0.0F, 60000.0F, 1.0F};
  const Vector3d sun = directionAt(pixels, 40, 70);
  const PanoramaLight light = lightOf(pixels);
  const double peak = arriving(light, sun).x();
  EXPECT_GT(peak, 1.0);
  Directions directions;
  for (int i = 0; i < 200; ++i) {
    const Vector3d normal = directions.next();
    EXPECT_NEAR(arriving(light, normal).x() / peak, std::max(0.0, normal.dot(sun)), 0.03);
  }
}

TEST(PanoramaLight, IsThePanoramaItselfInAMirror) {
  cv::Mat pixels(64, 128, CV_8UC4);
  cv::theRNG().state = 7;
  cv::randu(pixels, 0, 256);
  const PanoramaLight light = lightOf(pixels);
  for (int row = 0; row < pixels.rows; row += 3) {
    for (int column = 0; column < pixels.cols; column += 3) {
      const Vector3d expected = linearOf(pixels.at<cv::Vec4b>(row, column));
      EXPECT_LT(
          (mirrored(light, directionAt(pixels, row, column), 0.0) - expected).cwiseAbs().maxCoeff(),
          2e-3)
          << row << " " << column;
    }
  }
}

TEST(PanoramaLight, LiesBetweenThePixelsOfAMirrorWithoutASeam) {
  cv::Mat pixels(8, 16, CV_8UC4);
  cv::theRNG().state = 8;
  cv::randu(pixels, 0, 256);
  const PanoramaLight light = lightOf(pixels);
  const auto expectMean = [&](double row, double column, const std::array<cv::Vec4b, 2>& two) {
    const Vector3d expected = 0.5 * (linearOf(two[0]) + linearOf(two[1]));
    EXPECT_LT(
        (mirrored(light, directionAt(pixels, row, column), 0.0) - expected).cwiseAbs().maxCoeff(),
        2e-3)
        << row << " " << column;
  };
  const auto pixel = [&](int row, int column) { return pixels.at<cv::Vec4b>(row, column); };
  expectMean(3.5, 6.0, {pixel(3, 6), pixel(4, 6)});
  expectMean(5.0, 2.5, {pixel(5, 2), pixel(5, 3)});
  expectMean(5.0, 15.4999, {pixel(5, 15), pixel(5, 0)});
  expectMean(5.0, -0.4999, {pixel(5, 15), pixel(5, 0)});
  expectMean(-0.5, 3.0, {pixel(0, 3), pixel(0, 11)});
  expectMean(7.5, 9.0, {pixel(7, 9), pixel(7, 1)});
}

TEST(PanoramaLight, IsBlurredByTheLobeOfRoughSurfaces) {
  const cv::Mat pixels = scenery(300);
  const PanoramaLight light = lightOf(pixels);
  Directions directions;
  for (const double roughness : {0.125, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.75, 0.9, 1.0}) {
    double worst = 0.0;
    for (int i = 0; i < 12; ++i) {
      const Vector3d way = directions.next();
      const double error = (mirrored(light, way, roughness) - throughLobe(pixels, way, roughness))
                               .cwiseAbs()
                               .maxCoeff();
      worst = std::max(worst, error);
    }
    EXPECT_LT(worst, 0.03) << roughness;
  }
}

TEST(PanoramaLight, ArrivesFromItsHalvesApart) {
  cv::Mat pixels = plain({0, 0, 255, 255});
  pixels.rowRange(0, 50).setTo(cv::Scalar(255, 0, 0, 255));
  const PanoramaLight light = lightOf(pixels);
  for (const double height : {-1.0, -0.3, 0.0, 0.6, 1.0}) {
    const Vector3d normal(0, std::sqrt(1.0 - height * height), height);
    const Vector3d above = of(light.above().arriving(along(normal)));
    const Vector3d below = of(light.below().arriving(along(normal)));
    EXPECT_LT((above - Vector3d(0, 0, 0.5 + 0.5 * height)).norm(), 2e-3) << height;
    EXPECT_LT((below - Vector3d(0.5 - 0.5 * height, 0, 0)).norm(), 2e-3) << height;
  }
}

TEST(PanoramaLight, GrowsSofterWithRoughness) {
  const PanoramaLight light = lightOf(scenery(300));
  const Vector3d window = Vector3d(1.0, 0.0, 0.1).normalized();
  double before = 1.0;
  for (int step = 1; step <= 50; ++step) {
    const double red = mirrored(light, window, step / 50.0).x();
    EXPECT_LT(red, before + 6e-3) << step;
    EXPECT_GT(red, before - 0.06) << step;
    before = red;
  }
  EXPECT_LT(before, 0.6);
}

}  // namespace panorama_light_test
}  // namespace synthetic_dataset::render

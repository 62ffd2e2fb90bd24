#include "render/light/environment_light.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/renderer.h"
#include "render/sensor/srgb.h"
#include "support/box_world.h"

namespace synthetic_dataset::render {
namespace environment_light_test {

using Eigen::Vector3d;

world::BackgroundPicture panorama(const cv::Mat& pixels) {
  auto texture = std::make_shared<world::Texture>();
  texture->pixels = pixels;
  return {texture, world::BackgroundPicture::Projection::kPanorama};
}

cv::Mat plain(const cv::Scalar& pixel) { return {100, 200, CV_8UC4, pixel}; }

/// A blue sky over a brown ground, and a bright window in the east (+x).
cv::Mat scenery() {
  cv::Mat pixels = plain({60, 90, 120, 255});
  pixels.rowRange(0, 50).setTo(cv::Scalar(230, 170, 90, 255));
  pixels(cv::Rect(85, 35, 30, 25)).setTo(cv::Scalar(255, 255, 255, 255));
  return pixels;
}

Vector3d arriving(const EnvironmentLight& light, const Vector3d& normal) {
  const Lanes3 result = light.arriving(lanes(Eigen::Vector3f(normal.cast<float>())));
  return {double{result.x.get0()}, double{result.y.get0()}, double{result.z.get0()}};
}

/// From all pixels of the picture.
Vector3d summedUp(const cv::Mat& pixels, const Vector3d& normal) {
  Vector3d sum = Vector3d::Zero();
  for (int row = 0; row < pixels.rows; ++row) {
    const double elevation = M_PI * (0.5 - (row + 0.5) / pixels.rows);
    const double area = 2.0 * M_PI * M_PI * std::cos(elevation) / (pixels.rows * pixels.cols);
    for (int column = 0; column < pixels.cols; ++column) {
      // The middle is +x, and to its right is -y.
      const double azimuth = M_PI * (1.0 - 2.0 * (column + 0.5) / pixels.cols);
      const Vector3d from(std::cos(elevation) * std::cos(azimuth),
                          std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      const auto& pixel = pixels.at<cv::Vec4b>(row, column);
      const auto& linear = linearFromSrgb();
      const Vector3d colour(linear[pixel[2]], linear[pixel[1]], linear[pixel[0]]);
      sum += std::max(0.0, from.dot(normal)) * area / M_PI * colour;
    }
  }
  return sum;
}

TEST(EnvironmentLight, IsThatOfAllPixelsByTheirCosines) {
  const cv::Mat pixels = scenery();
  const EnvironmentLight light(panorama(pixels));
  std::mt19937 random(5);
  std::normal_distribution<double> normally;
  double brightest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Vector3d normal =
        Vector3d(normally(random), normally(random), normally(random)).normalized();
    const Vector3d expected = summedUp(pixels, normal);
    EXPECT_LT((arriving(light, normal) - expected).cwiseAbs().maxCoeff(), 0.02);
    brightest = std::max(brightest, expected.maxCoeff());
  }
  EXPECT_GT(brightest, 0.5);
}

TEST(EnvironmentLight, OfOneColourIsThatColour) {
  const EnvironmentLight white(panorama(plain({255, 255, 255, 255})));
  EXPECT_LT((arriving(white, {0, 0.6, 0.8}) - Vector3d::Ones()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(EnvironmentLight, TurnsAndBrightensWithItsPicture) {
  world::BackgroundPicture picture = panorama(scenery());
  const EnvironmentLight before(picture);
  picture.yaw = M_PI / 2.0;  // from x to y
  picture.brightness = 0.5;
  const EnvironmentLight after(picture);
  EXPECT_LT((0.5 * arriving(before, {1, 0, 0}) - arriving(after, {0, 1, 0})).cwiseAbs().maxCoeff(),
            1e-4);
}

/// A white cube from the south-west, in a look with a panorama and no other light.
cv::Mat cubeIn(const cv::Mat& pixels, LightDetail detail, world::Simulator simulator) {
  world::Description description;
  description.simulator = simulator;
  description.ambient = {0.4F, 0.4F, 0.4F};
  test::Stage stage;
  world::Material white;
  white.roughness = 1.0F;
  stage.addBox({1, 1, 1}, Pose::Identity(), 0, white);
  RenderOptions options;
  options.light = detail;
  Renderer renderer(description, stage.links(), options);
  world::Look look(description);
  look.background_picture = panorama(pixels);
  renderer.setLook(look);
  Eigen::Matrix3d R_WC;  // along +y, so that the south face is seen; x is right
  R_WC << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const View view{CameraModel(64, 64, {60, 60, 31.5, 31.5}, 0.1, 100.0),
                  makePose({0, -2, 0}, Eigen::Quaterniond(R_WC))};
  return renderer.colour(view, stage.poses(), {stage.all(), stage.all()});
}

TEST(EnvironmentLight, ColoursWhatStandsInIt) {
  cv::Mat red_south = plain({0, 0, 0, 255});
  red_south.colRange(100, 200).setTo(cv::Scalar(0, 0, 255, 255));  // -y
  cv::Mat red_north = plain({0, 0, 0, 255});
  red_north.colRange(0, 100).setTo(cv::Scalar(0, 0, 255, 255));
  for (const auto simulator : {world::Simulator::kGz, world::Simulator::kClassic}) {
    const auto facing = cubeIn(red_south, LightDetail::kFull, simulator).at<cv::Vec3b>(32, 32);
    EXPECT_GT(facing[2], 240);
    EXPECT_LT(facing[0], 10);
    const auto behind = cubeIn(red_north, LightDetail::kFull, simulator).at<cv::Vec3b>(32, 32);
    EXPECT_LT(behind[2], 60);
    const auto simple = cubeIn(red_south, LightDetail::kSimple, simulator).at<cv::Vec3b>(32, 32);
    EXPECT_EQ(simple[0], simple[2]);
  }
}

}  // namespace environment_light_test
}  // namespace synthetic_dataset::render

/// Fog, sky and unusual lights.

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/light/light_setup.h"
#include "render/overlay/sky_painter.h"
#include "render/picture_taking.h"
#include "render/renderer.h"

namespace synthetic_dataset::render {
namespace surroundings_test {

using test::kSmallCamera;
using test::screen;
using test::Stage;
using test::takePicture;

world::Material unlit(float channel, float alpha = 1.0F) {
  world::Material material;
  material.diffuse = {channel, channel, channel, alpha};
  material.lit = false;
  return material;
}

int encoded(double linear) {
  const double value =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255.0 * value));
}

int green(const cv::Mat& image, int u = 32, int v = 24) { return image.at<cv::Vec3b>(v, u)[1]; }

/// A black screen at 4 m in white fog.
int blackScreenIn(const world::Fog& fog, int u = 32) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.background.setZero();
  description.fog = fog;
  Stage stage;
  stage.addMesh(screen(8.0F, 4.0F), Pose::Identity(), 0, unlit(0.0F));
  return green(takePicture(description, stage), u);
}

TEST(Fog, LinearGrowsFromStartToEnd) {
  world::Fog fog;
  fog.start = 2.0;
  fog.end = 10.0;
  EXPECT_NEAR(blackScreenIn(fog), encoded(0.25), 1);
}

TEST(Fog, ExponentialFollowsItsDensity) {
  world::Fog fog;
  fog.type = world::FogType::kExponential;
  fog.density = 0.1;
  EXPECT_NEAR(blackScreenIn(fog), encoded(1.0 - std::exp(-0.4)), 1);
}

TEST(Fog, SquaredExponentialFollowsItsDensity) {
  world::Fog fog;
  fog.type = world::FogType::kSquaredExponential;
  fog.density = 0.1;
  EXPECT_NEAR(blackScreenIn(fog), encoded(1.0 - std::exp(-0.16)), 1);
}

TEST(Fog, IsThickerTowardsThePicturesCorners) {
  world::Fog fog;
  fog.type = world::FogType::kExponential;
  fog.density = 0.1;
  EXPECT_GT(blackScreenIn(fog, 2), blackScreenIn(fog, 32));
}

TEST(Fog, LiesOnWhatOneCanSeeThroughToo) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.background.setZero();
  description.fog.emplace();
  description.fog->start = 0.0;
  description.fog->end = 8.0;
  Stage stage;
  stage.addMesh(screen(8.0F, 4.0F), Pose::Identity(), -1, unlit(0.0F));
  stage.addMesh(screen(8.0F, 2.0F), Pose::Identity(), -1, unlit(0.0F, 0.5F));
  // Fog of 0.5 on the wall and of 0.25 on the pane before it, half of each.
  EXPECT_NEAR(green(takePicture(description, stage)), encoded(0.5 * 0.25 + 0.5 * 0.5), 1);
}

TEST(Fog, LeavesTheBackgroundAsItIs) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.background.setConstant(0.2F);
  description.fog.emplace();
  EXPECT_EQ(green(takePicture(description, Stage())), 51);
}

/// Looks along a direction of the world, with +z up in the picture.
Pose lookingAlong(const Eigen::Vector3d& direction) {
  Eigen::Matrix3d R_WC;
  R_WC.col(2) = direction.normalized();
  R_WC.col(0) = R_WC.col(2).cross(Eigen::Vector3d::UnitZ()).normalized();
  R_WC.col(1) = R_WC.col(2).cross(R_WC.col(0));
  return makePose({0, 0, 1}, Eigen::Quaterniond(R_WC));
}

cv::Vec3b skyAlong(const world::Sky& sky, const Eigen::Vector3d& direction) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.sky = sky;
  return takePicture(description, Stage(), lookingAlong(direction)).at<cv::Vec3b>(24, 32);
}

TEST(Sky, IsBlueAboveAndPalerAtTheHorizon) {
  world::Sky sky;
  sky.time = 12.0;
  const cv::Vec3b high = skyAlong(sky, {0.3, 1.0, 1.5});
  const cv::Vec3b low = skyAlong(sky, {0.3, 1.0, 0.02});
  EXPECT_GT(high[0], high[1] + 20) << "more blue than green";
  EXPECT_GT(high[1], high[2] + 10) << "more green than red";
  EXPECT_GT(low[2], high[2] + 40) << "brighter and whiter below";
}

TEST(Sky, IsDarkAtNight) {
  world::Sky sky;
  sky.time = 1.0;
  for (const double height : {0.05, 0.5, 2.0}) {
    EXPECT_LT(cv::norm(skyAlong(sky, {1.0, 0.2, height}), cv::NORM_INF), 40.0);
  }
}

TEST(Sky, GlowsRedWhereTheSunHasSet) {
  world::Sky sky;
  sky.time = sky.sunset - 0.1;
  const cv::Vec3b west = skyAlong(sky, {-1.0, 0.1, 0.03});
  EXPECT_GT(west[2], west[0] + 30);
}

TEST(Sky, TurnsWithTheCamera) {
  // The same direction has the same colour wherever in the picture it is.
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.sky.emplace();
  description.sky->cloud_humidity = 0.6;
  const Pose X_WC = lookingAlong({1, 2, 0.8});
  Pose rolled = X_WC;
  rolled.linear() = X_WC.linear() * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  const cv::Mat upright = takePicture(description, Stage(), X_WC);
  const cv::Mat turned = takePicture(description, Stage(), rolled);
  // The camera is turned clockwise by a quarter: its right is what was below.
  for (const int offset : {-20, -7, 0, 13, 22}) {
    const cv::Vec3b first = upright.at<cv::Vec3b>(24 + offset, 32);
    const cv::Vec3b second = turned.at<cv::Vec3b>(24, 32 + offset);
    EXPECT_LE(cv::norm(first, second, cv::NORM_INF), 2.0) << offset;
  }
}

TEST(Sky, HumidityBringsClouds) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.sky.emplace();
  const Pose X_WC = lookingAlong({0.2, 1, 1.2});
  const cv::Mat clear = takePicture(description, Stage(), X_WC);
  description.sky->cloud_humidity = 0.9;
  const cv::Mat cloudy = takePicture(description, Stage(), X_WC);
  const auto blueness = [](const cv::Mat& image) {
    const cv::Scalar mean = cv::mean(image);
    return mean[0] - mean[2];
  };
  EXPECT_LT(blueness(cloudy), 0.6 * blueness(clear));
}

TEST(Sky, IsHiddenByWhatIsDrawn) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.sky.emplace();
  Stage stage;
  stage.addMesh(screen(8.0F, 4.0F), Pose::Identity(), 0, unlit(0.4F));
  EXPECT_EQ(green(takePicture(description, stage)), 102);
}

TEST(Sky, StaysOutOfPixelsThatAreNotDrawn) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.sky.emplace();
  description.background.setZero();
  const Stage stage;
  Renderer renderer(description, stage.links(), {});
  const ColourPass pass{{}, {}, Sampling::kCentre, {cv::Rect(10, 10, 20, 20)}};
  const cv::Mat image = renderer.colour({kSmallCamera, lookingAlong({1, 0, 1})}, {}, pass);
  EXPECT_GT(green(image, 20, 20), 0);
  EXPECT_EQ(green(image, 40, 20), 0);
}

TEST(Sky, ItsSunIsTheDirectionalLightByDay) {
  world::Light light;
  light.direction_L = Eigen::Vector3d(1, 2, -2) / 3.0;
  EXPECT_TRUE(sunDirection({}, {light}).isApprox(Eigen::Vector3d(-1, -2, 2) / 3.0));
}

TEST(Sky, ItsSunRisesInTheEastAndSetsInTheWest) {
  world::Sky sky;
  sky.time = sky.sunrise;
  EXPECT_TRUE(sunDirection(sky, {}).isApprox(Eigen::Vector3d::UnitX(), 1e-9));
  sky.time = 0.5 * (sky.sunrise + sky.sunset);
  EXPECT_NEAR(sunDirection(sky, {}).z(), std::sin(M_PI / 3), 1e-9);
  sky.time = sky.sunset;
  EXPECT_TRUE(sunDirection(sky, {}).isApprox(-Eigen::Vector3d::UnitX(), 1e-9));
  sky.time = 23.0;
  EXPECT_LT(sunDirection(sky, {}).z(), 0.0);
}

/// A matte grey wall at 2 m, lit only by these lights.
int wallUnder(const std::vector<world::Light>& lights, float ambient = 0.0F) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.background.setZero();
  description.ambient.setConstant(ambient);
  description.lights = lights;
  world::Material material;
  material.diffuse = {0.5F, 0.5F, 0.5F, 1.0F};
  material.specular.setZero();
  Stage stage;
  stage.addMesh(screen(4.0F, 2.0F), Pose::Identity(), 0, material);
  return green(takePicture(description, stage));
}

TEST(Lights, AmbientAloneShowsTheWorld) { EXPECT_GT(wallUnder({}, 0.8F), 60); }

TEST(Lights, BrighterThanOneKeepSurfacesBelowWhite) {
  world::Light light;
  light.direction_L = {0, 0, 1};
  const int once = wallUnder({light});
  light.diffuse.setConstant(3.0F);
  const int thrice = wallUnder({light});
  EXPECT_GT(thrice, once);
  EXPECT_LT(thrice, 255) << "0.64 in linear light";
}

TEST(Lights, ASpotWhoseInnerAngleIsTheWiderOneStillShines) {
  world::Light light;
  light.type = world::LightType::kSpot;
  light.direction_L = {0, 0, 1};
  light.spot_inner_angle = 1.2;
  light.spot_outer_angle = 0.8;
  EXPECT_NEAR(wallUnder({light}), 128, 1);
}

TEST(Lights, EndAtTheirRange) {
  world::Light light;
  light.type = world::LightType::kPoint;
  light.range = 1.9;
  EXPECT_EQ(wallUnder({light}), 0);
  light.range = 2.1;
  EXPECT_NEAR(wallUnder({light}), 128, 1);
}

TEST(Lights, ThatShouldCastShadowsAndDoNotAreNoted) {
  std::vector<world::Light> lights(6);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i].name = "lamp" + std::to_string(i);
    lights[i].casts_shadow = true;
  }
  lights[0].type = world::LightType::kPoint;
  EXPECT_THAT(lightNotes(lights, LightDetail::kSimple),
              ::testing::ElementsAre("light 'lamp0' casts no shadow: point lights do so only "
                                     "with rendering/light: full"));
  EXPECT_TRUE(lightNotes(lights, LightDetail::kFull).empty());
}

TEST(Lights, OfAHallCountWhereTheyReach) {
  world::Light lamp;
  lamp.type = world::LightType::kPoint;
  lamp.range = 1.9;
  std::vector<world::Light> lights(300, lamp);
  EXPECT_EQ(wallUnder(lights), 0);
  lights[250].range = 2.1;
  EXPECT_NEAR(wallUnder(lights), 128, 1);
}

TEST(Lights, OfWhichTooManyCastShadowsAreNoted) {
  world::Light lamp;
  lamp.type = world::LightType::kSpot;
  lamp.casts_shadow = true;
  std::vector<world::Light> lights(33, lamp);
  EXPECT_THAT(lightNotes(lights, LightDetail::kSimple),
              ::testing::ElementsAre("the world has 33 lights that cast shadows; the 32 strongest "
                                     "do so"));
  lights[3].range = 1.0;
  const std::vector<std::size_t> strongest = strongestLights(lights, 32);
  EXPECT_EQ(strongest.size(), 32U);
  EXPECT_THAT(strongest, ::testing::Not(::testing::Contains(3U)));
}

}  // namespace surroundings_test
}  // namespace synthetic_dataset::render

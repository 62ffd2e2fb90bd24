/// The sky, or a panorama behind the world, as the light of the objects in it.

#include "render/overlay/environment.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/picture_taking.h"
#include "render/pixels/srgb.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace environment_test {

using Eigen::Vector3d;
using test::kSmallCamera;

world::BackgroundPicture panorama(const cv::Mat& pixels) {
  auto texture = std::make_shared<world::Texture>();
  texture->pixels = pixels;
  return {texture, world::BackgroundPicture::Projection::kPanorama};
}

cv::Mat plain(const cv::Scalar& pixel) { return {100, 200, CV_8UC4, pixel}; }

/// Colours that change slowly all around, none of them too bright.
cv::Mat manyColours() {
  cv::Mat pixels(256, 512, CV_8UC4);
  for (int row = 0; row < pixels.rows; ++row) {
    for (int column = 0; column < pixels.cols; ++column) {
      const double turn = 2.0 * M_PI * (column + 0.5) / pixels.cols;
      pixels.at<cv::Vec4b>(row, column) =
          cv::Vec4b(cv::saturate_cast<std::uint8_t>(120 + 80 * std::sin(turn)),
                    cv::saturate_cast<std::uint8_t>(120 + 80 * std::cos(2 * turn)),
                    cv::saturate_cast<std::uint8_t>(40 + 150 * row / pixels.rows), 255);
    }
  }
  return pixels;
}

world::Description gzWorld() {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient = {0.4F, 0.4F, 0.4F};
  return description;
}

world::Material silver(float roughness = 0.0F) {
  world::Material material;
  material.metalness = 1.0F;
  material.roughness = roughness;
  return material;
}

/// The small camera, upright, along a direction of the world.
View viewAlong(const Vector3d& direction, const Vector3d& from = {0, 0, 0}) {
  Eigen::Matrix3d R_WC;
  R_WC.col(2) = direction.normalized();
  R_WC.col(0) = R_WC.col(2).cross(Vector3d::UnitZ()).normalized();
  R_WC.col(1) = R_WC.col(2).cross(R_WC.col(0));
  return {kSmallCamera, makePose(from, Eigen::Quaterniond(R_WC))};
}

class Scenery {
 public:
  explicit Scenery(world::Description description, LightDetail detail = LightDetail::kFull)
      : description_(std::move(description)), look_(description_) {
    options_.light = detail;
  }

  world::Look& look() { return look_; }
  test::Stage& stage() { return stage_; }

  cv::Mat seenFrom(const View& view) {
    Renderer renderer(description_, stage_.links(), options_);
    return seenFrom(view, renderer);
  }

  std::unique_ptr<Renderer> renderer() {
    return std::make_unique<Renderer>(description_, stage_.links(), options_);
  }

  cv::Mat seenFrom(const View& view, Renderer& renderer) {
    renderer.setLook(look_);
    return renderer.colour(view, stage_.poses(), {stage_.all(), stage_.all()});
  }

 private:
  world::Description description_;
  world::Look look_;
  RenderOptions options_;
  test::Stage stage_;
};

/// A white cube from the south, in a look with a panorama and no other light.
cv::Vec3b southOfACube(const cv::Mat& pixels, LightDetail detail, world::Simulator simulator) {
  world::Description description = gzWorld();
  description.simulator = simulator;
  Scenery scenery(description, detail);
  scenery.look().background_picture = panorama(pixels);
  world::Material white;
  white.roughness = 1.0F;
  scenery.stage().addBox({1, 1, 1}, Pose::Identity(), 0, white);
  return scenery.seenFrom(viewAlong(Vector3d::UnitY(), {0, -2, 0})).at<cv::Vec3b>(24, 32);
}

TEST(Environment, ColoursWhatStandsInIt) {
  cv::Mat red_south = plain({0, 0, 0, 255});
  red_south.colRange(100, 200).setTo(cv::Scalar(0, 0, 255, 255));  // -y
  cv::Mat red_north = plain({0, 0, 0, 255});
  red_north.colRange(0, 100).setTo(cv::Scalar(0, 0, 255, 255));
  for (const auto simulator : {world::Simulator::kGz, world::Simulator::kClassic}) {
    const cv::Vec3b facing = southOfACube(red_south, LightDetail::kFull, simulator);
    EXPECT_GT(facing[2], 240);
    EXPECT_LT(facing[0], 10);
    EXPECT_LT(southOfACube(red_north, LightDetail::kFull, simulator)[2], 60);
    const cv::Vec3b simple = southOfACube(red_south, LightDetail::kSimple, simulator);
    EXPECT_EQ(simple[0], simple[2]);
  }
}

TEST(Environment, OfWhiteIsWhatWhiteAmbientLightIsOnAFloor) {
  const auto floorIn = [](bool has_panorama) {
    world::Description description = gzWorld();
    description.ambient = {1.0F, 1.0F, 1.0F};
    Scenery scenery(description);
    world::Material grey;
    grey.diffuse = {0.6F, 0.6F, 0.6F, 1.0F};
    grey.specular.setZero();
    grey.roughness = 1.0F;
    scenery.stage().addBox({9, 9, 1}, Pose::Identity(), 0, grey);
    if (has_panorama) scenery.look().background_picture = panorama(plain({255, 255, 255, 255}));
    return scenery.seenFrom(viewAlong({0.01, 0, -1}, {0, 0, 3})).at<cv::Vec3b>(24, 32);
  };
  EXPECT_LE(cv::norm(floorIn(true), floorIn(false), cv::NORM_INF), 3.0);
  EXPECT_GT(floorIn(true)[0], 140);
}

/// Adds a mirror that fills the picture of a camera looking along +x and shows what lies along +y.
void addMirror(Scenery& scenery, double roughness = 0.0) {
  Eigen::Matrix3d R_WL = Eigen::AngleAxisd(M_PI / 4.0, Vector3d::UnitZ()).toRotationMatrix();
  scenery.stage().addBox({9, 0.01, 9}, makePose({2, 0, 0}, Eigen::Quaterniond(R_WL)), 0,
                         silver(static_cast<float>(roughness)));
}

/// The difference between the mirror's picture and the flipped view in the mirrored direction, +y.
cv::Mat mirrorErrors(Scenery& mirror, Scenery& nothing) {
  addMirror(mirror);
  const cv::Mat shown = mirror.seenFrom(viewAlong(Vector3d::UnitX()));
  cv::Mat expected;
  cv::flip(nothing.seenFrom(viewAlong(Vector3d::UnitY())), expected, 1);
  const cv::Rect inner(4, 4, 57, 41);
  cv::Mat errors;
  cv::absdiff(shown(inner), expected(inner), errors);
  return errors;
}

TEST(Environment, IsSeenInAMirror) {
  Scenery mirror(gzWorld());
  Scenery nothing(gzWorld());
  for (Scenery* each : {&mirror, &nothing}) {
    each->look().background_picture = panorama(manyColours());
    each->look().background_picture->yaw = 0.7;
    each->look().background_picture->brightness = 0.8;
  }
  EXPECT_LE(cv::norm(mirrorErrors(mirror, nothing), cv::NORM_INF), 2.0);
}

TEST(Environment, OfASkyIsSeenInAMirror) {
  for (const double humidity : {0.0, 0.6}) {
    world::Description description = gzWorld();
    description.sky.emplace();
    description.sky->cloud_humidity = humidity;
    description.ambient = {0.9F, 0.9F, 0.9F};  // has no part in it
    Scenery mirror(description);
    Scenery nothing(description);
    const cv::Mat errors = mirrorErrors(mirror, nothing);
    EXPECT_LT(cv::norm(errors, cv::NORM_L1) / static_cast<double>(errors.total() * 3), 1.5)
        << humidity;
    if (humidity > 0.0) continue;  // the edges of clouds are sharper than the panorama's pixels
    EXPECT_LE(cv::norm(errors, cv::NORM_INF), 2.0);
  }
}

/// A matte grey floor or ceiling under a sky, without other lights.
cv::Vec3b slabUnderASky(LightDetail detail, double from_height, float ambient = 0.6F,
                        world::Simulator simulator = world::Simulator::kGz) {
  world::Description description = gzWorld();
  description.simulator = simulator;
  description.ambient.setConstant(ambient);
  description.sky.emplace();
  Scenery scenery(description, detail);
  world::Material grey;
  grey.diffuse = {0.6F, 0.6F, 0.6F, 1.0F};
  grey.ambient = {0.6F, 0.6F, 0.6F};
  grey.specular.setZero();
  grey.roughness = 1.0F;
  scenery.stage().addBox({9, 9, 1}, Pose::Identity(), 0, grey);
  return scenery.seenFrom(viewAlong({0.01, 0, -from_height}, {0, 0, from_height}))
      .at<cv::Vec3b>(24, 32);
}

double luminanceOf(const cv::Vec3b& pixel) {
  const auto& linear = linearFromSrgb();
  return 0.2126 * double{linear[pixel[2]]} + 0.7152 * double{linear[pixel[1]]} +
         0.0722 * double{linear[pixel[0]]};
}

TEST(Environment, OfASkyGivesFloorsWhatTheAmbientLightSays) {
  for (const float ambient : {0.3F, 0.6F, 0.9F}) {
    const double simple = luminanceOf(slabUnderASky(LightDetail::kSimple, 3.0, ambient));
    const double full = luminanceOf(slabUnderASky(LightDetail::kFull, 3.0, ambient));
    EXPECT_NEAR(full / simple, 1.0, 0.1) << ambient;
    const auto classic = world::Simulator::kClassic;
    EXPECT_NEAR(luminanceOf(slabUnderASky(LightDetail::kFull, 3.0, ambient, classic)) /
                    luminanceOf(slabUnderASky(LightDetail::kSimple, 3.0, ambient, classic)),
                1.0, 0.1)
        << ambient;
  }
}

TEST(Environment, OfASkyIsBlueOnFloorsAndDarkerBelow) {
  const cv::Vec3b floor = slabUnderASky(LightDetail::kFull, 3.0);
  EXPECT_GT(floor[0], floor[2] + 10);
  const double below = luminanceOf(slabUnderASky(LightDetail::kFull, -3.0));
  EXPECT_NEAR(below / luminanceOf(slabUnderASky(LightDetail::kSimple, -3.0)), 1.0, 0.15);
  EXPECT_LT(below, 0.7 * luminanceOf(floor));
}

/// Pictures of different looks by one renderer, against those by a renderer for each look.
void expectThoseOfEachLookAlone(Scenery& scenery, const std::vector<world::Look>& looks) {
  const View view = viewAlong(Vector3d::UnitX());
  std::vector<cv::Mat> pictures;
  {
    const std::unique_ptr<Renderer> renderer = scenery.renderer();
    for (const world::Look& look : looks) {
      scenery.look() = look;
      pictures.push_back(scenery.seenFrom(view, *renderer));
    }
  }
  for (std::size_t i = 0; i < looks.size(); ++i) {
    scenery.look() = looks[i];
    EXPECT_EQ(cv::norm(pictures[i], scenery.seenFrom(view), cv::NORM_INF), 0.0) << i;
    if (i == 0) continue;
    EXPECT_GT(cv::norm(pictures[i], pictures[i - 1], cv::NORM_INF), 30.0) << i;
  }
}

TEST(Environment, OfASkyFollowsTheSun) {
  world::Description description = gzWorld();
  description.sky.emplace();
  description.lights.resize(1);
  Scenery scenery(description);
  addMirror(scenery);
  world::Look north(description);
  north.lights[0].direction_L = Vector3d(0, -1, -0.3).normalized();
  world::Look south = north;
  south.lights[0].direction_L = Vector3d(0, 1, -0.3).normalized();
  expectThoseOfEachLookAlone(scenery, {north, south, north});
}

TEST(Environment, IsThatOfTheLookHoweverOftenPanoramasTakeTurns) {
  Scenery scenery(gzWorld());
  scenery.stage().addMesh(world::sphereMesh(1.0),
                          makePose({3, 0, 0}, Eigen::Quaterniond::Identity()), 0, silver(0.3F));
  const world::Look none(gzWorld());
  world::Look green = none;
  green.background_picture = panorama(plain({20, 180, 20, 255}));
  world::Look many = none;
  many.background_picture = panorama(manyColours());
  world::Look turned = many;
  turned.background_picture->yaw = 2.0;
  expectThoseOfEachLookAlone(scenery, {green, many, green, turned, many, none, green});
}

TEST(Environment, IsNoneBeforeABackdropAndWithSimpleLight) {
  world::Description description = gzWorld();
  description.sky.emplace();
  Scenery with_sky(description);
  Scenery without(gzWorld());
  for (Scenery* each : {&with_sky, &without}) {
    addMirror(*each);
    each->look().background_picture = panorama(plain({20, 180, 20, 255}));
    each->look().background_picture->projection = world::BackgroundPicture::Projection::kBackdrop;
  }
  const View view = viewAlong(Vector3d::UnitX());
  EXPECT_EQ(cv::norm(with_sky.seenFrom(view), without.seenFrom(view), cv::NORM_INF), 0.0);
}

}  // namespace environment_test
}  // namespace synthetic_dataset::render

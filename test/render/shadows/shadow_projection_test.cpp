/// Which lights cast shadows, and where.

#include "render/shadows/shadow_projection.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/renderer.h"
#include "support/box_world.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace shadow_projection_test {

using test::Stage;

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

world::Material matte() {
  world::Material material;
  material.diffuse = {0.6F, 0.6F, 0.6F, 1.0F};
  material.specular.setZero();
  material.roughness = 1.0F;
  return material;
}

/// A camera at a place that looks along a direction.
Pose lookingAlong(const Eigen::Vector3d& eye, const Eigen::Vector3d& ahead) {
  return makePose(eye, Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), ahead));
}

TEST(PointLights, CastShadowsAllAround) {
  world::Light lamp;
  lamp.type = world::LightType::kPoint;
  lamp.casts_shadow = true;
  lamp.range = 20.0;
  lamp.attenuation_linear = 0.0;
  lamp.attenuation_quadratic = 0.0;
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient.setZero();
  description.lights = {lamp};
  RenderOptions options;
  options.light = LightDetail::kFull;
  constexpr double kWall = 2.0;   // [m] how far away walls are
  constexpr double kBall = 0.05;  // [m] radius
  constexpr double kHalfWay = 1.0;
  // Balls before the middle of each wall, and before some edges and corners of the cube.
  std::vector<Eigen::Vector3d> balls;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) balls.emplace_back(sign * Eigen::Vector3d::Unit(axis));
  }
  balls.emplace_back(Eigen::Vector3d(1, 1, 0));
  balls.emplace_back(Eigen::Vector3d(0, -1, 1));
  balls.emplace_back(Eigen::Vector3d(-1, 1, -1));
  Stage stage;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d outwards = sign * Eigen::Vector3d::Unit(axis);
      stage.addMesh(world::planeMesh(-outwards, {2 * kWall, 2 * kWall}),
                    makePose(kWall * outwards, Eigen::Quaterniond::Identity()), -1, matte());
    }
  }
  for (Eigen::Vector3d& ball : balls) {
    ball *= kHalfWay;
    stage.addMesh(world::sphereMesh(kBall), at(ball.x(), ball.y(), ball.z()), 0, matte());
  }
  const CameraModel camera(120, 120, {70.0, 70.0, 59.5, 59.5}, 0.01, 100.0);
  Renderer renderer(description, stage.links(), options);
  int shaded = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d outwards = sign * Eigen::Vector3d::Unit(axis);
      // From beside the light, so that balls do not hide their shadows.
      const Eigen::Vector3d eye =
          0.3 * Eigen::Vector3d::Unit((axis + 1) % 3) + 0.3 * Eigen::Vector3d::Unit((axis + 2) % 3);
      const View view{camera, lookingAlong(eye, outwards)};
      const cv::Mat picture = renderer.colour(view, stage.poses(), {stage.all(), stage.all()});
      for (int v = 0; v < picture.rows; ++v) {
        for (int u = 0; u < picture.cols; ++u) {
          const Eigen::Vector3d ray =
              view.X_WC.linear() * Eigen::Vector3d((u - 59.5) / 70.0, (v - 59.5) / 70.0, 1.0);
          const auto nearest = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
            double least = 1e9;
            for (const Eigen::Vector3d& ball : balls) {
              const double along = std::max((ball - from).dot(way) / way.squaredNorm(), 0.0);
              least = std::min(least, (ball - from - along * way).norm());
            }
            return least;
          };
          if (nearest(eye, ray) < kBall + 0.02) continue;  // a ball, or beside one
          double way = 1e9;
          for (int i = 0; i < 3; ++i) {
            if (ray[i] != 0.0)
              way = std::min(way, (std::copysign(kWall, ray[i]) - eye[i]) / ray[i]);
          }
          const Eigen::Vector3d place = eye + way * ray;
          const double passes = nearest(Eigen::Vector3d::Zero(), place);
          const int level = picture.at<cv::Vec3b>(v, u)[1];
          if (passes < kBall - 0.025) {
            EXPECT_EQ(level, 0) << place.transpose();
            ++shaded;
          } else if (passes > kBall + 0.025) {
            EXPECT_GT(level, 60) << place.transpose();
          }
        }
      }
    }
  }
  EXPECT_GT(shaded, 60);
}

TEST(ShadowLayout, GivesManyLightsSmallerMaps) {
  std::vector<world::Light> lights(3);
  for (world::Light& light : lights) light.casts_shadow = true;
  lights[1].type = world::LightType::kPoint;
  const ShadowLayout simple = shadowLayout(lights, 2048, LightDetail::kSimple);
  EXPECT_EQ(simple.first_maps, (std::vector<int>{0, -1, 1}));
  EXPECT_EQ(simple.map_size, 2048);
  EXPECT_EQ(simple.sides, 0);
  const ShadowLayout full = shadowLayout(lights, 2048, LightDetail::kFull);
  EXPECT_EQ(full.first_maps, (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(full.sides, 6);
  EXPECT_LE(6 * full.side_size * full.side_size, 2048 * 2048) << "a cube is no larger than a map";
  lights.resize(32, lights[0]);
  const ShadowLayout many = shadowLayout(lights, 2048, LightDetail::kFull);
  EXPECT_EQ(many.maps, 31);
  EXPECT_LE(many.maps * many.map_size * many.map_size, 4 * 2048 * 2048);
}

TEST(ManyLights, EachCastShadows) {
  constexpr int kLights = 9;
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient.setZero();
  Stage stage;
  stage.addMesh(world::planeMesh(Eigen::Vector3d::UnitZ(), {12, 4}), at(0, 0, 0), -1, matte());
  for (int i = 0; i < kLights; ++i) {
    world::Light lamp;
    lamp.type = world::LightType::kSpot;
    lamp.casts_shadow = true;
    lamp.X_WL = at(i - 4.0, 0, 2.0);
    lamp.direction_L = -Eigen::Vector3d::UnitZ();
    lamp.spot_inner_angle = 0.3;
    lamp.spot_outer_angle = 0.4;
    lamp.range = 10.0;
    description.lights.push_back(lamp);
    stage.addBox({0.1, 0.1, 0.02}, at(i - 4.0, 0, 1.0), 0, matte());
  }
  for (const LightDetail light : {LightDetail::kSimple, LightDetail::kFull}) {
    RenderOptions options;
    options.light = light;
    Renderer renderer(description, stage.links(), options);
    for (int i = 0; i < kLights; ++i) {
      const View view{CameraModel(64, 64, {64.0, 64.0, 31.5, 31.5}, 0.01, 100.0),
                      makePose({i - 4.0, 0, 0.9}, Eigen::Quaterniond(0, 1, 0, 0))};
      const cv::Mat picture = renderer.colour(view, stage.poses(), {stage.all(), stage.all()});
      EXPECT_EQ(picture.at<cv::Vec3b>(31, 31)[1], 0) << "below the box, light " << i;
      EXPECT_GT(picture.at<cv::Vec3b>(31, 31 + 13)[1], 50) << "beside its shadow, light " << i;
    }
  }
}

}  // namespace shadow_projection_test
}  // namespace synthetic_dataset::render

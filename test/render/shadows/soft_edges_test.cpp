/// Shadows of area lights, against rays to all parts of these lights.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace soft_edges_test {

using test::Stage;

constexpr double kSunRadius = 0.00462516;  // the tangent of half of 0.53 degrees
constexpr double kLampRadius = 0.03;       // [m]

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

/// A floor of 4 m under a single light.
struct Room {
  explicit Room(const world::Light& light) {
    description.simulator = world::Simulator::kGz;
    description.ambient.setZero();
    description.background.setZero();
    description.lights = {light};
    description.lights[0].casts_shadow = true;
    options.light = LightDetail::kFull;
    stage.addMesh(world::planeMesh(Eigen::Vector3d::UnitZ(), {4, 4}), at(0, 0, 0), -1, matte());
  }

  /// The share of the light that arrives at each pixel: linear light relative to that of a picture
  /// without shadows.
  [[nodiscard]] cv::Mat passing() const {
    const auto linear = [&](const std::vector<bool>& casting) {
      Renderer renderer(description, stage.links(), options);
      const cv::Mat picture = renderer.colour(view, stage.poses(), {stage.all(), casting});
      cv::Mat result(picture.size(), CV_64FC1);
      for (int v = 0; v < picture.rows; ++v) {
        for (int u = 0; u < picture.cols; ++u) {
          const auto encoded = static_cast<float>(picture.at<cv::Vec3b>(v, u)[1]) / 255.0F;
          const Eigen::Vector3f grey(encoded, encoded, encoded);
          result.at<double>(v, u) = linearFromSrgb(grey).x();
        }
      }
      return result;
    };
    return linear(stage.all()) / linear(std::vector<bool>(stage.poses().size(), false));
  }

  /// The point of the floor that a pixel's centre sees.
  [[nodiscard]] Eigen::Vector3d floorAt(int u, int v) const {
    const Intrinsics& k = view.camera.intrinsics();
    const Eigen::Vector3d ray =
        view.X_WC.linear() * Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0);
    const Eigen::Vector3d eye = view.X_WC.translation();
    return eye - eye.z() / ray.z() * ray;
  }

  world::Description description;
  RenderOptions options;
  Stage stage;
  View view{CameraModel(160, 120, {120.0, 120.0, 79.5, 59.5}, 0.05, 100.0),
            makePose({0, 0, 1.9}, Eigen::Quaterniond(0, 1, 0, 0))};  // downwards
};

/// The share of a disc for which a predicate is true.
/// @param is_seen  takes a point of the disc of radius 1
double shareOf(const std::function<bool(const Eigen::Vector2d&)>& is_seen) {
  int count = 0;
  int seen = 0;
  for (double x = -0.975; x < 1.0; x += 0.05) {
    for (double y = -0.975; y < 1.0; y += 0.05) {
      if (x * x + y * y > 1.0) continue;
      ++count;
      if (is_seen({x, y})) ++seen;
    }
  }
  return static_cast<double>(seen) / count;
}

/// @param lit  the share of the light that arrives at a place of the floor
void expectShares(const Room& room, const std::function<double(const Eigen::Vector3d&)>& lit) {
  const cv::Mat passing = room.passing();
  double sum = 0.0;
  double worst = 0.0;
  int partly = 0;
  for (int v = 0; v < passing.rows; ++v) {
    for (int u = 0; u < passing.cols; ++u) {
      const double wanted = lit(room.floorAt(u, v));
      const double difference = std::abs(passing.at<double>(v, u) - wanted);
      sum += difference;
      worst = std::max(worst, difference);
      if (wanted > 0.1 && wanted < 0.9) ++partly;
    }
  }
  EXPECT_GT(partly, 300) << "pixels that see a part of the light";
  EXPECT_LT(sum / static_cast<double>(passing.total()), 0.01);
  EXPECT_LT(worst, 0.25);
}

TEST(SoftEdges, InTheSunAreAsWideAsItIs) {
  world::Light sun;
  sun.direction_L = Eigen::Vector3d(0.3, 0.1, -1.0).normalized();
  Room room(sun);
  room.view.X_WC.translation() = Eigen::Vector3d(0.2, 0.2, 0.9);
  constexpr double kHeight = 3.0;
  room.stage.addMesh(world::planeMesh(Eigen::Vector3d::UnitZ(), {0.4, 0.6}), at(-0.7, 0, kHeight),
                     0, matte());
  const Eigen::Vector3d side = sun.direction_L.unitOrthogonal();
  const Eigen::Vector3d other = sun.direction_L.cross(side);
  expectShares(room, [&](const Eigen::Vector3d& place) {
    return shareOf([&](const Eigen::Vector2d& of_disc) {
      const Eigen::Vector3d way =
          -sun.direction_L + kSunRadius * (of_disc.x() * side + of_disc.y() * other);
      const Eigen::Vector3d hit = place + kHeight / way.z() * way;
      return std::abs(hit.x() + 0.7) > 0.2 || std::abs(hit.y()) > 0.3;
    });
  });
}

TEST(SoftEdges, OfALampAreAsWideAsItIs) {
  world::Light lamp;
  lamp.type = world::LightType::kPoint;
  lamp.X_WL = at(0.2, 0.1, 2.0);
  lamp.range = 10.0;
  lamp.attenuation_constant = 1.0;
  lamp.attenuation_linear = 0.0;
  lamp.attenuation_quadratic = 0.0;
  Room room(lamp);
  room.view.X_WC.translation() = Eigen::Vector3d(0, 0, 0.9);
  room.stage.addMesh(world::planeMesh(Eigen::Vector3d::UnitZ(), {0.3, 0.4}), at(0.1, 0, 1.0), 0,
                     matte());
  expectShares(room, [&](const Eigen::Vector3d& place) {
    return shareOf([&](const Eigen::Vector2d& of_disc) {
      const Eigen::Vector3d part =
          lamp.X_WL.translation() + kLampRadius * Eigen::Vector3d(of_disc.x(), of_disc.y(), 0.0);
      const Eigen::Vector3d hit = place + (part - place) / part.z();
      return std::abs(hit.x() - 0.1) > 0.15 || std::abs(hit.y()) > 0.2;
    });
  });
}

TEST(SoftEdges, AreSharpWhereAThingStands) {
  world::Light sun;
  sun.direction_L = Eigen::Vector3d(1.0, 0.0, -1.0).normalized();
  Room room(sun);
  room.stage.addBox({0.4, 1.0, 0.3}, at(0, 0, 0.15), 0, matte());
  const cv::Mat passing = room.passing();
  // The box's right side is at 0.2; from above its top hides a part of the floor beyond.
  for (int u = 0; u < passing.cols; ++u) {
    const double x = room.floorAt(u, 60).x();
    const double top = 0.2 * 1.9 / 1.6;
    if (x > top + 0.02 && x < 0.48) {
      EXPECT_LT(passing.at<double>(60, u), 0.03) << "at " << x << " m";
    }
    if (x > 0.52) {
      EXPECT_GT(passing.at<double>(60, u), 0.97) << "at " << x << " m";
    }
  }
}

TEST(SoftEdges, LeaveWhatIsNotInAShadowAsItIs) {
  for (const double slant : {0.2, 1.0, 3.0}) {
    world::Light sun;
    sun.direction_L = Eigen::Vector3d(slant, 0.3 * slant, -1.0).normalized();
    Room room(sun);
    room.stage.addMesh(world::sphereMesh(0.3), at(0, 0, 0.8), 0, matte());
    room.stage.addBox({0.3, 0.3, 0.3}, at(0.7, 0.7, 0.15), 1, matte());
    const cv::Mat passing = room.passing();
    const Eigen::Vector3d towards = -sun.direction_L;
    for (int v = 0; v < passing.rows; ++v) {
      for (int u = 0; u < passing.cols; ++u) {
        // Points of a sphere whose normals have a cosine of 0.2 or more to the sun are not in the
        // sphere's own shadow.
        const Eigen::Vector3d eye = room.view.X_WC.translation();
        const Eigen::Vector3d ray = (room.floorAt(u, v) - eye).normalized();
        const Eigen::Vector3d middle(0, 0, 0.8);
        const double along = ray.dot(middle - eye);
        const double beside = (middle - eye - along * ray).norm();
        if (beside > 0.28) continue;
        const Eigen::Vector3d hit = eye + (along - std::sqrt(0.3 * 0.3 - beside * beside)) * ray;
        if ((hit - middle).normalized().dot(towards) < 0.25) continue;
        EXPECT_GT(passing.at<double>(v, u), 0.97) << "pixel " << u << ", " << v;
      }
    }
  }
}

/// The brightness of a floor below a light of this type, optionally inside a ball.
double brightnessBelow(world::LightType type, bool is_in_ball) {
  world::Light lamp;
  lamp.type = type;
  lamp.X_WL = at(0, 0, 2.0);
  lamp.direction_L = -Eigen::Vector3d::UnitZ();
  lamp.spot_inner_angle = 1.5;
  lamp.spot_outer_angle = 2.0;
  lamp.range = 10.0;
  Room room(lamp);
  room.stage.addMesh(world::sphereMesh(0.06), at(is_in_ball ? 0 : 5, 0, 2.0), 0, matte());
  Renderer renderer(room.description, room.stage.links(), room.options);
  const cv::Mat picture =
      renderer.colour(room.view, room.stage.poses(), {room.stage.all(), room.stage.all()});
  return cv::mean(picture)[1];
}

TEST(PointLights, ShineOutOfTheirBulbs) {
  const double free = brightnessBelow(world::LightType::kPoint, false);
  EXPECT_GT(free, 50.0);
  EXPECT_NEAR(brightnessBelow(world::LightType::kPoint, true), free, 0.5);
}

}  // namespace soft_edges_test
}  // namespace synthetic_dataset::render

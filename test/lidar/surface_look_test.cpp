#include "lidar/surface_look.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "lidar/ray_bodies.h"
#include "lidar/scanned_hall.h"

namespace synthetic_dataset::lidar {
namespace surface_look_test {

using test::boxMesh;

world::Material painted(float grey, float roughness = 1.0F) {
  world::Material material;
  material.diffuse = {grey, grey, grey, 1.0F};
  material.roughness = roughness;
  return material;
}

/// The left half is a hole, the right half is white.
std::shared_ptr<const world::Texture> halfAHole() {
  auto texture = std::make_shared<world::Texture>();
  texture->pixels = cv::Mat(8, 8, CV_8UC4, cv::Scalar(255, 255, 255, 255));
  texture->pixels(cv::Rect(0, 0, 4, 8)).setTo(cv::Scalar(255, 255, 255, 0));
  return texture;
}

double intensityOf(const world::Material& material, double cosine) {
  return intensityAt(*boxMesh({1, 1, 1}), material, {0, 0.3, 0.3}, world::Simulator::kGz, cosine);
}

TEST(SurfaceLook, IsAsBrightAsItsColourInLight) {
  EXPECT_NEAR(intensityOf(painted(1.0F), 1.0), 1.0, 1e-6);
  EXPECT_NEAR(intensityOf(painted(0.5F), 1.0), 0.214, 1e-3);  // sRGB's 0.5
  EXPECT_NEAR(intensityOf(painted(0.5F), 0.5), 0.107, 1e-3);
  EXPECT_EQ(intensityOf(painted(0.0F), 1.0), 0.0);
}

TEST(SurfaceLook, ShinesAroundTheNormalWhereItIsSmooth) {
  EXPECT_GT(intensityOf(painted(0.2F, 0.3F), 1.0), intensityOf(painted(0.2F), 1.0));
  EXPECT_NEAR(intensityOf(painted(0.2F, 0.3F), 0.5), intensityOf(painted(0.2F), 0.5), 1e-3);
}

TEST(RayBodies, LetRaysThroughHolesAndBacks) {
  world::Material material = painted(1.0F);
  material.texture = halfAHole();
  ASSERT_TRUE(hasHoles(material));
  RayBodies bodies;
  const std::size_t body = bodies.add({{boxMesh({2, 2, 2}), &material, 0, Pose::Identity(), true}});
  const Paint paint = {&material};
  const auto along = [&](double y) {
    return bodies.meet(body, {-5.0, y, 0.1}, {1.0, 0.0, 0.0}, 0.0, 100.0, paint);
  };
  const auto left = along(0.5);
  const auto right = along(-0.5);
  ASSERT_NE(left.has_value(), right.has_value());  // the ray also passes the far face's back
  EXPECT_NEAR((left ? left : right)->distance, 4.0, 1e-9);
  EXPECT_FALSE(bodies.meet(body, {0.0, 0.1, 0.2}, {1.0, 0.0, 0.0}, 0.0, 100.0, paint));
}

TEST(ScannedWorld, LeavesOutGlassAsLabelsDo) {
  world::Description description;
  world::Material glass = painted(1.0F);
  glass.diffuse.w() = 0.3F;
  description.models.push_back(
      test::modelOf("window", boxMesh({0.1, 4, 4}), test::poseAt(2, 0, 0), glass));
  description.models.push_back(test::modelOf("wall", boxMesh({0.1, 4, 4}), test::poseAt(4, 0, 0)));
  world::World world(std::move(description), {}, world::PhysicsOptions());
  const auto rangeThrough = [&](render::GlassInLabels how) {
    const ScannedWorld scanned(world, how);
    const auto hit = scanned.bodies().meet(*scanned.standing(), -scanned.standingOrigin(),
                                           {1, 0, 0}, 0.0, 100.0, scanned.paint({}));
    return hit ? hit->distance : 0.0;
  };
  EXPECT_NEAR(rangeThrough(render::GlassInLabels::kOfObjects), 3.95, 1e-6);
  EXPECT_NEAR(rangeThrough(render::GlassInLabels::kSolid), 1.95, 1e-6);
}

}  // namespace surface_look_test
}  // namespace synthetic_dataset::lidar

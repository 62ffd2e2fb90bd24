/// Hulls around meshes, against how far the meshes' own vertices reach in random directions.

#include "render/parts/bounding_hull.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "support/random_poses.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace bounding_hull_test {

constexpr double kRounding = 1e-6;  // [m]

template <class Points>
double reach(const Points& points, const Eigen::Vector3d& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& point : points) {
    most = std::max(most, direction.dot(point.template cast<double>()));
  }
  return most;
}

std::vector<Eigen::Vector3d> directionsAtRandom() {
  std::mt19937 random(11);
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < 200; ++i) {
    directions.push_back(test::randomOrientation(random) * Eigen::Vector3d::UnitX());
  }
  return directions;
}

world::Mesh meshOf(const std::vector<Eigen::Vector3f>& positions) {
  world::Mesh mesh;
  mesh.positions = positions;
  return mesh;
}

/// A lump, a needle and a plate that are turned and away from the origin.
std::vector<world::Mesh> lumps() {
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::vector<world::Mesh> meshes;
  for (const Eigen::Vector3f& size :
       {Eigen::Vector3f(0.2F, 0.3F, 0.4F), {1.0F, 1e-3F, 1e-3F}, {1.0F, 1.0F, 0.0F}}) {
    const Eigen::Matrix3f turn = test::randomOrientation(random).toRotationMatrix().cast<float>();
    std::vector<Eigen::Vector3f> positions;
    for (int i = 0; i < 60; ++i) {
      const Eigen::Vector3f place(normal(random), normal(random), normal(random));
      positions.emplace_back(turn * size.cwiseProduct(place) + Eigen::Vector3f(3.0F, -2.0F, 1.0F));
    }
    meshes.push_back(meshOf(positions));
  }
  return meshes;
}

TEST(BoundingHull, HoldsTheMesh) {
  for (const world::Mesh& mesh : lumps()) {
    const BoundingHull hull = boundingHullOf(mesh);
    for (const Eigen::Vector3d& direction : directionsAtRandom()) {
      EXPECT_GE(reach(hull.corners, direction), reach(mesh.positions, direction) - kRounding);
    }
  }
}

TEST(BoundingHull, HoldsWhatIsRoundTheMeshByAMargin) {
  for (const world::Mesh& mesh : lumps()) {
    const BoundingHull hull = boundingHullOf(mesh);
    for (const double margin : {1e-4, 0.05, 2.0}) {
      const std::vector<Eigen::Vector3d> corners = hull.cornersWith(margin);
      for (const Eigen::Vector3d& direction : directionsAtRandom()) {
        EXPECT_GE(reach(corners, direction), reach(mesh.positions, direction) + margin - kRounding);
      }
    }
  }
}

TEST(BoundingHull, IsCloseToABall) {
  constexpr double kRadius = 0.4;
  const BoundingHull hull = boundingHullOf(*world::sphereMesh(kRadius));
  EXPECT_LE(hull.corners.size(), 48U);
  EXPECT_NEAR(hull.radius, kRadius, 0.01);
  for (const Eigen::Vector3d& corner : hull.corners) EXPECT_LT(corner.norm(), 1.2 * kRadius);
  for (const Eigen::Vector3d& corner : hull.cornersWith(0.1)) {
    EXPECT_LT(corner.norm(), 1.2 * (kRadius + 0.11));
  }
}

TEST(BoundingHull, OfABoxIsTheBox) {
  const BoundingHull hull = boundingHullOf(*world::boxMesh({0.2, 0.4, 0.6}));
  EXPECT_EQ(hull.corners.size(), 8U);
  for (const Eigen::Vector3d& corner : hull.corners) {
    EXPECT_TRUE(corner.cwiseAbs().isApprox(Eigen::Vector3d(0.1, 0.2, 0.3), 1e-6));
  }
}

TEST(BoundingHull, OfAPointIsThePoint) {
  const BoundingHull hull = boundingHullOf(meshOf({{1.0F, 2.0F, 3.0F}}));
  ASSERT_EQ(hull.corners.size(), 1U);
  EXPECT_TRUE(hull.corners.front().isApprox(Eigen::Vector3d(1.0, 2.0, 3.0), 1e-6));
  EXPECT_EQ(hull.cornersWith(0.5).size(), 8U);
  EXPECT_TRUE(boundingHullOf(meshOf({})).corners.empty());
}

}  // namespace bounding_hull_test
}  // namespace synthetic_dataset::render

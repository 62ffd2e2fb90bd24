#include "world/physics/convex_hull.h"

#include <gtest/gtest.h>

#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace convex_hull_test {

std::vector<Eigen::Vector3d> pointsOf(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> points;
  for (const auto& position : mesh.positions) points.push_back(position.cast<double>());
  return points;
}

TEST(ConvexHull, DropsPointsInside) {
  std::vector<Eigen::Vector3d> points = pointsOf(*weldedBoxMesh({1, 1, 1}));
  points.emplace_back(0.1, 0.2, -0.3);
  points.emplace_back(0.0, 0.0, 0.5);

  EXPECT_EQ(convexHull(points).vertices.size(), 8U);
}

TEST(ConvexHull, InsetMovesEveryFace) {
  const ConvexHull hull = convexHull(pointsOf(*weldedBoxMesh({1, 2, 3})), 0.01);

  EXPECT_NEAR(hull.inset, 0.01, 1e-6);
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    EXPECT_TRUE(vertex.cwiseAbs().isApprox(Eigen::Vector3d(0.49, 0.99, 1.49), 1e-3)) << vertex;
  }
}

TEST(ConvexHull, InsetLeavesAThinHullWhole) {
  const ConvexHull hull = convexHull(pointsOf(*weldedBoxMesh({1, 1, 0.002})), 0.01);

  EXPECT_LE(hull.inset, 0.0005);
  EXPECT_GE(hull.vertices.size(), 8U);
}

TEST(SupportPoints, KeepTheShapeOfARoundCloud) {
  const std::vector<Eigen::Vector3d> all = pointsOf(*sphereMesh(1.0, 40));

  const std::vector<Eigen::Vector3d> support = supportPoints(all, 256);

  EXPECT_LE(support.size(), 256U);
  for (const Eigen::Vector3d& direction : all) {
    double reach = 0.0;
    for (const Eigen::Vector3d& point : support) reach = std::max(reach, point.dot(direction));
    EXPECT_GT(reach, 0.98);
  }
}

}  // namespace convex_hull_test
}  // namespace synthetic_dataset::world

#include "world/mesh/closed_surface.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "support/box_world.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace closed_surface_test {

/// A mesh joined with another one, which is shifted.
Mesh together(Mesh mesh, const Mesh& other, const Eigen::Vector3f& shift) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Eigen::Vector3f& position : other.positions)
    mesh.positions.push_back(position + shift);
  for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
  return mesh;
}

Mesh insideOut(Mesh mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::swap(mesh.indices[i], mesh.indices[i + 1]);
  }
  return mesh;
}

TEST(ClosedSurface, IsThatOfTheStandardShapes) {
  EXPECT_TRUE(isSurfaceOfBodies(*boxMesh({0.3, 0.2, 1.7})));
  EXPECT_TRUE(isSurfaceOfBodies(*sphereMesh(0.31)));
  EXPECT_TRUE(isSurfaceOfBodies(*ellipsoidMesh({0.3, 20.0, 0.01})));
  EXPECT_TRUE(isSurfaceOfBodies(*cylinderMesh(0.1, 3.0)));
  EXPECT_TRUE(isSurfaceOfBodies(*capsuleMesh(0.1, 3.0)));
  EXPECT_TRUE(isSurfaceOfBodies(*test::boxMesh({1, 2, 3})));
}

TEST(ClosedSurface, IsNotOneWithoutATriangleNorAPlate) {
  Mesh box = *boxMesh({1, 1, 1});
  box.indices.resize(box.indices.size() - 3);
  EXPECT_FALSE(isSurfaceOfBodies(box));
  EXPECT_FALSE(isSurfaceOfBodies(*planeMesh(Eigen::Vector3d::UnitZ(), {1, 1})));
  EXPECT_FALSE(isSurfaceOfBodies({}));
}

TEST(ClosedSurface, IsNotOneWithATurnedTriangle) {
  Mesh box = *boxMesh({1, 1, 1});
  std::swap(box.indices[0], box.indices[1]);
  EXPECT_FALSE(isSurfaceOfBodies(box));
}

TEST(ClosedSurface, IsNotOneThatFacesInwardsAsARoomDoes) {
  EXPECT_FALSE(isSurfaceOfBodies(insideOut(*boxMesh({1, 1, 1}))));
  EXPECT_FALSE(
      isSurfaceOfBodies(together(*boxMesh({9, 9, 9}), insideOut(*boxMesh({1, 1, 1})), {20, 0, 0})));
}

TEST(ClosedSurface, IsNotOneThatTouchesAnotherThatIsInsideOut) {
  const Mesh box = *boxMesh({2, 2, 2});
  const Mesh leg = *boxMesh({1, 1, 1});
  const Eigen::Vector3f by_a_corner(1.5F, 1.5F, 1.5F);
  EXPECT_TRUE(isSurfaceOfBodies(together(box, leg, by_a_corner)));
  EXPECT_FALSE(isSurfaceOfBodies(together(box, insideOut(leg), by_a_corner)));
}

TEST(ClosedSurface, MayHaveTrianglesWithoutArea) {
  Mesh box = *boxMesh({1, 1, 1});
  box.indices.insert(box.indices.end(), {box.indices[0], box.indices[1], box.indices[1]});
  EXPECT_TRUE(isSurfaceOfBodies(box));
}

TEST(ClosedSurface, MayBeOfSeveralBodies) {
  EXPECT_TRUE(isSurfaceOfBodies(together(*boxMesh({1, 1, 1}), *sphereMesh(0.2), {5, 0, 0})));
  EXPECT_TRUE(isSurfaceOfBodies(together(*boxMesh({1, 1, 1}), *sphereMesh(0.4), {0.5, 0, 0})));
}

TEST(ClosedSurface, MayHaveASeamThatWasWorkedOutTwice) {
  Mesh box = *boxMesh({0.3, 0.2, 1.7});
  for (Eigen::Vector3f& position : box.positions) position += Eigen::Vector3f(0.15F, 0.1F, 0.85F);
  Eigen::Vector3f& zero =
      *std::min_element(box.positions.begin(), box.positions.end(),
                        [](const auto& a, const auto& b) { return a.norm() < b.norm(); });
  ASSERT_EQ(zero.norm(), 0.0F);
  zero.x() = -1e-17F;
  EXPECT_TRUE(isSurfaceOfBodies(box));
  zero.x() = 0.001F;
  EXPECT_FALSE(isSurfaceOfBodies(box));
}

TEST(ClosedSurface, IsNotOneThatReachesInfinity) {
  Mesh box = *boxMesh({1, 1, 1});
  box.positions[0].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(isSurfaceOfBodies(box));
  box.positions[0].x() = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(isSurfaceOfBodies(box));
}

}  // namespace closed_surface_test
}  // namespace synthetic_dataset::world

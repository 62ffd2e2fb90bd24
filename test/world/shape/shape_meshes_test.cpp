#include "world/shape/shape_meshes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <gmock/gmock.h>

namespace synthetic_dataset::world {
namespace shape_meshes_test {

using testing::Each;

constexpr double kPi = 3.14159265358979323846;

Eigen::Vector3d corner(const Mesh& mesh, std::size_t index) {
  return mesh.positions[mesh.indices[index]].cast<double>();
}

/// By the divergence theorem; positive only if the triangles are counter-clockwise from outside.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    sum += corner(mesh, i).dot(corner(mesh, i + 1).cross(corner(mesh, i + 2))) / 6.0;
  }
  return sum;
}

/// The least cosine between a triangle's side and the normals of its corners.
double worstNormal(const Mesh& mesh) {
  double worst = 1.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Eigen::Vector3d a = corner(mesh, i);
    const Eigen::Vector3d normal =
        (corner(mesh, i + 1) - a).cross(corner(mesh, i + 2) - a).normalized();
    for (std::size_t k = i; k < i + 3; ++k) {
      worst = std::min(worst, normal.dot(mesh.normals[mesh.indices[k]].cast<double>()));
    }
  }
  return worst;
}

std::vector<double> normalLengths(const Mesh& mesh) {
  std::vector<double> lengths;
  for (const Eigen::Vector3f& normal : mesh.normals) lengths.push_back(normal.norm());
  return lengths;
}

void expectWhole(const Mesh& mesh) {
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.texture_coordinates.size(), mesh.positions.size());
  EXPECT_THAT(normalLengths(mesh), Each(testing::DoubleNear(1.0, 1e-5)));
  EXPECT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()), mesh.positions.size());
}

TEST(BoxMesh, HasTheVolumeAndFlatFaces) {
  const auto mesh = boxMesh({1, 2, 3});
  expectWhole(*mesh);
  EXPECT_NEAR(volume(*mesh), 6.0, 1e-6);
  EXPECT_NEAR(worstNormal(*mesh), 1.0, 1e-6);
}

TEST(SphereMesh, IsNowhereDeeperThanTwoPerMill) {
  const auto mesh = sphereMesh(2.0);
  expectWhole(*mesh);
  for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
    const Eigen::Vector3d a = corner(*mesh, i);
    const Eigen::Vector3d b = corner(*mesh, i + 1);
    const Eigen::Vector3d c = corner(*mesh, i + 2);
    EXPECT_NEAR(a.norm(), 2.0, 1e-5);
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    EXPECT_GT(normal.dot(a), 2.0 * (1.0 - 0.002));  // of the triangle's plane from the centre
  }
}

TEST(SphereMesh, HasSmoothNormals) { EXPECT_GT(worstNormal(*sphereMesh(0.5)), 0.996); }

TEST(EllipsoidMesh, HasTheVolume) {
  const auto mesh = ellipsoidMesh({1, 2, 3});
  expectWhole(*mesh);
  EXPECT_NEAR(volume(*mesh) / (4.0 / 3.0 * kPi * 6.0), 1.0, 0.004);
  EXPECT_GT(worstNormal(*mesh), 0.98);
}

TEST(CylinderMesh, HasTheVolumeAndClosedCaps) {
  const auto mesh = cylinderMesh(0.5, 4.0);
  expectWhole(*mesh);
  EXPECT_NEAR(volume(*mesh) / kPi, 1.0, 0.002);
  EXPECT_GT(worstNormal(*mesh), 0.998);
}

TEST(CapsuleMesh, HasTheVolumeOfACylinderAndASphere) {
  const auto mesh = capsuleMesh(1.0, 3.0);
  expectWhole(*mesh);
  EXPECT_NEAR(volume(*mesh) / (3.0 * kPi + 4.0 / 3.0 * kPi), 1.0, 0.003);
  Eigen::AlignedBox3f bounds;
  for (const Eigen::Vector3f& position : mesh->positions) bounds.extend(position);
  EXPECT_NEAR(bounds.sizes().z(), 5.0, 1e-5);
}

TEST(PlaneMesh, FacesItsNormal) {
  const auto mesh = planeMesh({0, 0, 1}, {4, 6});
  expectWhole(*mesh);
  EXPECT_NEAR(worstNormal(*mesh), 1.0, 1e-6);
  for (const Eigen::Vector3f& position : mesh->positions) {
    EXPECT_FLOAT_EQ(std::abs(position.x()), 2.0F);
    EXPECT_FLOAT_EQ(std::abs(position.y()), 3.0F);
    EXPECT_FLOAT_EQ(position.z(), 0.0F);
  }
}

TEST(PlaneMesh, TurnsWithItsNormal) {
  const auto mesh = planeMesh({1, 0, 0}, {4, 6});
  for (const Eigen::Vector3f& normal : mesh->normals) EXPECT_NEAR(normal.x(), 1.0F, 1e-6F);
  for (const Eigen::Vector3f& position : mesh->positions) {
    EXPECT_NEAR(position.x(), 0.0F, 1e-6F);
    EXPECT_NEAR(std::abs(position.y()), 3.0F, 1e-6F);
    EXPECT_NEAR(std::abs(position.z()), 2.0F, 1e-6F);
  }
}

TEST(PlaneMesh, ShowsTheTexturesFirstRowAtTheTop) {
  const auto mesh = planeMesh({0, 0, 1}, {2, 2});
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
    const Eigen::Vector2f& uv = mesh->texture_coordinates[i];
    EXPECT_FLOAT_EQ(mesh->positions[i].x(), 2.0F * uv.x() - 1.0F);
    EXPECT_FLOAT_EQ(mesh->positions[i].y(), 1.0F - 2.0F * uv.y());
  }
}

}  // namespace shape_meshes_test
}  // namespace synthetic_dataset::world

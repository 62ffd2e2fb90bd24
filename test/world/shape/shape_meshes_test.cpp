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

/// The least cosine between a triangle's own normal and the normals at its corners.
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
    EXPECT_GT(normal.dot(a), 2.0 * (1.0 - 0.002));  // the plane's distance from the centre
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

/// The texture coordinates at the point that a ray from outside meets.
Eigen::Vector2d pictureAt(const Mesh& mesh, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& along) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Eigen::Matrix3d edges;
    edges << corner(mesh, i + 1) - corner(mesh, i), corner(mesh, i + 2) - corner(mesh, i), -along;
    const Eigen::Vector3d s = edges.inverse() * (from - corner(mesh, i));
    const bool faces = edges.col(0).cross(edges.col(1)).dot(along) < 0.0;
    if (!faces || s.head<2>().minCoeff() < 0.0 || s.head<2>().sum() > 1.0) continue;
    const auto uv = [&](std::size_t k) {
      return Eigen::Vector2d(mesh.texture_coordinates[mesh.indices[i + k]].cast<double>());
    };
    return uv(0) + s.x() * (uv(1) - uv(0)) + s.y() * (uv(2) - uv(0));
  }
  ADD_FAILURE() << "the ray meets nothing";
  return {0, 0};
}

void expectPicture(const Mesh& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                   double u, double v) {
  const Eigen::Vector2d found = pictureAt(mesh, from, along);
  EXPECT_NEAR(found.x() - std::floor(found.x()), u, 0.01) << from.transpose();
  EXPECT_NEAR(found.y(), v, 0.01) << from.transpose();
}

/// Gazebo's MeshManager::CreateBox: on the top and the bottom face the picture's right is -y; its
/// upper edge is at +x on the top and at -x on the bottom.
TEST(BoxMesh, TurnsItsPicturesAsGazebo) {
  const auto mesh = boxMesh({2, 2, 2});
  expectPicture(*mesh, {0.5, 0.6, 5}, {0, 0, -1}, 0.2, 0.25);
  expectPicture(*mesh, {0.5, 0.6, -5}, {0, 0, 1}, 0.2, 0.75);
  expectPicture(*mesh, {5, 0.6, 0.5}, {-1, 0, 0}, 0.8, 0.25);
  expectPicture(*mesh, {-5, 0.6, 0.5}, {1, 0, 0}, 0.2, 0.25);
  expectPicture(*mesh, {0.6, 5, 0.5}, {0, -1, 0}, 0.2, 0.25);
  expectPicture(*mesh, {0.6, -5, 0.5}, {0, 1, 0}, 0.8, 0.25);
}

/// MeshManager::CreateSphere: the picture runs around y, from z to x, with its upper edge at +y.
TEST(SphereMesh, HasItsPictureAroundYAsGazebo) {
  const auto mesh = sphereMesh(1.0);
  for (double turn = 0.013; turn < 1.0; turn += 0.083) {
    for (const double v : {0.2, 0.5, 0.7}) {
      const double s = std::sin(kPi * v);
      const Eigen::Vector3d out(s * std::sin(2 * kPi * turn), std::cos(kPi * v),
                                s * std::cos(2 * kPi * turn));
      expectPicture(*mesh, 3.0 * out, -out, turn, v);
    }
  }
}

/// MeshManager::CreateCylinder: the picture runs around z, from y to x, with its first row at the
/// bottom. On the upper cap it is a fan around the first pixel.
TEST(CylinderMesh, HasItsPictureUpsideDownAroundZAsGazebo) {
  const auto mesh = cylinderMesh(1.0, 4.0);
  for (double turn = 0.013; turn < 1.0; turn += 0.083) {
    const Eigen::Vector3d out(std::sin(2 * kPi * turn), std::cos(2 * kPi * turn), 0);
    expectPicture(*mesh, 3.0 * out + Eigen::Vector3d(0, 0, 1), -out, turn, 0.75);
    expectPicture(*mesh, 0.5 * out + Eigen::Vector3d(0, 0, 5), {0, 0, -1}, 0.5 * turn, 0.5);
    expectPicture(*mesh, 0.5 * out + Eigen::Vector3d(0, 0, -5), {0, 0, 1}, 0.5 * turn, 0.0);
  }
}

/// So they are drawn and labelled as before, whatever their pictures are.
TEST(RoundMeshes, HaveTheirVerticesWhereTheyWereWithoutPictures) {
  const auto mesh = sphereMesh(1.0);
  const auto round = ellipsoidMesh({1, 1, 1});
  ASSERT_EQ(mesh->indices.size(), round->indices.size());
  for (std::size_t i = 0; i < mesh->indices.size(); ++i) {
    EXPECT_EQ(corner(*mesh, i), corner(*round, i));
  }
}

}  // namespace shape_meshes_test
}  // namespace synthetic_dataset::world

#include "world/mesh/object_mesh.h"

#include <random>

#include <gtest/gtest.h>

#include "support/box_world.h"
#include "support/random_poses.h"
#include "support/temporary_folder.h"
#include "world/mesh/farthest_pair.h"
#include "world/mesh/mesh_loader.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace object_mesh_test {

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

Link linkOf(std::shared_ptr<const Mesh> mesh, const Material& material = {},
            const Pose& X_LV = Pose::Identity()) {
  Link link;
  link.visuals.push_back({"visual", X_LV, {{std::move(mesh), material}}, true});
  return link;
}

/// The volume that the triangles enclose, positive if they are counter-clockwise from outside.
double volume(const ObjectModel& model) {
  double sum = 0.0;
  for (const ObjectModel::Triangle& triangle : model.triangles) {
    Eigen::Matrix3d corners;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto index = static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)]);
      corners.col(i) = model.vertices[index].position;
    }
    sum += corners.determinant() / 6.0;
  }
  return sum;
}

double bruteForceDiameter(const std::vector<Eigen::Vector3d>& points) {
  double largest = 0.0;
  for (const Eigen::Vector3d& a : points) {
    for (const Eigen::Vector3d& b : points) largest = std::max(largest, (a - b).norm());
  }
  return largest;
}

TEST(ObjectMesh, OfABoxHasItsCornersAndSides) {
  const Link box = linkOf(test::boxMesh({1, 2, 3}));

  const ObjectModel model = objectModel({&box}, {Pose::Identity()});

  EXPECT_EQ(model.vertices.size(), 24U);
  EXPECT_EQ(model.triangles.size(), 12U);
  EXPECT_NEAR(volume(model), 6.0, 1e-6);
  EXPECT_NEAR(model.diameter, std::sqrt(14.0), 1e-7);
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    EXPECT_TRUE(vertex.position.cwiseAbs().isApprox(Eigen::Vector3d(0.5, 1, 1.5)));
    EXPECT_GT(vertex.normal.dot(vertex.position), 0.0) << "points out";
    EXPECT_NEAR(vertex.normal.norm(), 1.0, 1e-7);
  }
}

TEST(ObjectMesh, PutsLinksAndVisualsWhereTheyStand) {
  const Pose X_LV = makePose({0, 0, 1}, Eigen::Quaterniond(0, 1, 0, 0));  // upside down
  const Link first = linkOf(test::boxMesh({2, 2, 2}), {}, X_LV);
  const Link second = linkOf(test::boxMesh({1, 1, 1}));

  const ObjectModel model = objectModel({&first, &second}, {at(0, 0, 0), at(5, 0, 0.5)});

  ASSERT_EQ(model.vertices.size(), 48U);
  EXPECT_EQ(model.triangles.size(), 24U);
  Eigen::AlignedBox3d bounds;
  for (const ObjectModel::Vertex& vertex : model.vertices) bounds.extend(vertex.position);
  EXPECT_LT((bounds.min() - Eigen::Vector3d(-1, -1, 0)).norm(), 1e-6);
  EXPECT_TRUE(bounds.max().isApprox(Eigen::Vector3d(5.5, 1, 2), 1e-6));
  EXPECT_NEAR(volume(model), 9.0, 1e-6);
  const Eigen::Vector3d before = second.visuals[0].surfaces[0].mesh->normals[0].cast<double>();
  EXPECT_TRUE(model.vertices[24].normal.isApprox(before));
  EXPECT_NEAR(model.diameter, Eigen::Vector3d(6.5, 1.5, 2.0).norm(), 1e-6);
}

TEST(ObjectMesh, OfAMirroredMeshIsStillTheRightWayRound) {
  test::TemporaryFolder folder;
  // A tetrahedron, counter-clockwise from outside.
  const auto path = folder.write("t.obj",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                 "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const ResourceFinder finder({}, {});
  MeshLoader loader(finder);
  for (const Eigen::Vector3d& scale :
       {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(-2, 1, 3), Eigen::Vector3d(-1, -1, -1)}) {
    MeshRequest request;
    request.file = path;
    request.scale = scale;
    const Link link = linkOf(loader.whole(request));

    const ObjectModel model = objectModel({&link}, {Pose::Identity()});

    EXPECT_NEAR(volume(model), std::abs(scale.prod()) / 6.0, 1e-6) << scale.transpose();
    const Eigen::Vector3d middle = 0.25 * scale;
    for (const ObjectModel::Vertex& vertex : model.vertices) {
      EXPECT_GT(vertex.normal.dot(vertex.position - middle), 0.0) << scale.transpose();
    }
  }
}

TEST(ObjectMesh, LeavesOutVerticesWithoutTriangles) {
  auto mesh = std::make_shared<Mesh>(*test::boxMesh({1, 1, 1}));
  mesh->positions.emplace_back(100.0F, 0.0F, 0.0F);
  mesh->normals.emplace_back(0.0F, 0.0F, 1.0F);
  const Link link = linkOf(mesh);

  const ObjectModel model = objectModel({&link}, {Pose::Identity()});

  EXPECT_EQ(model.vertices.size(), 24U);
  EXPECT_NEAR(model.diameter, std::sqrt(3.0), 1e-6);
}

TEST(ObjectMesh, TakesTheFacesNormalsWhereTheMeshHasNone) {
  auto mesh = std::make_shared<Mesh>(*test::boxMesh({1, 1, 1}));
  const std::vector<Eigen::Vector3f> normals = std::exchange(mesh->normals, {});
  const Link link = linkOf(mesh);

  const ObjectModel model = objectModel({&link}, {Pose::Identity()});

  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_TRUE(model.vertices[i].normal.isApprox(normals[i].cast<double>()));
  }
}

using Rgb = std::array<std::uint8_t, 3>;

TEST(ObjectMesh, HasTheMaterialsColour) {
  Material material;
  material.diffuse = {1.0F, 0.5F, 0.2F, 1.0F};
  const Link link = linkOf(test::boxMesh({1, 1, 1}), material);

  const ObjectModel model = objectModel({&link}, {Pose::Identity()});

  EXPECT_EQ(model.vertices[7].colour, (Rgb{255, 128, 51}));
}

TEST(ObjectMesh, MultipliesColoursAsLight) {
  auto mesh = std::make_shared<Mesh>(*test::boxMesh({1, 1, 1}));
  mesh->colours.assign(mesh->positions.size(), {0.5F, 1.0F, 0.0F, 1.0F});
  Material material;
  material.diffuse = {0.5F, 0.5F, 1.0F, 1.0F};
  const Link link = linkOf(mesh, material);

  const ObjectModel model = objectModel({&link}, {Pose::Identity()});

  // sRGB 0.5 is 0.2140 in linear light; its square, 0.0458, is sRGB 0.2370.
  EXPECT_EQ(model.vertices[0].colour, (Rgb{60, 128, 0}));
}

TEST(ObjectMesh, HasThePicturesColourAtEachVertex) {
  // Red | green over blue | yellow.
  auto texture = std::make_shared<Texture>();
  texture->pixels.create(2, 2, CV_8UC4);
  texture->pixels.at<cv::Vec4b>(0, 0) = {0, 0, 255, 255};
  texture->pixels.at<cv::Vec4b>(0, 1) = {0, 255, 0, 255};
  texture->pixels.at<cv::Vec4b>(1, 0) = {255, 0, 0, 255};
  texture->pixels.at<cv::Vec4b>(1, 1) = {0, 255, 255, 255};
  Material material;
  material.diffuse = {1.0F, 1.0F, 1.0F, 1.0F};
  material.texture = texture;
  const auto mesh = test::boxMesh({1, 1, 1});
  const Link link = linkOf(mesh, material);

  const ObjectModel model = objectModel({&link}, {Pose::Identity()});

  for (std::size_t i = 0; i < 24; ++i) {
    const bool right = mesh->texture_coordinates[i].x() > 0.5F;
    const bool low = mesh->texture_coordinates[i].y() > 0.5F;
    const Rgb wanted = low ? (right ? Rgb{255, 255, 0} : Rgb{0, 0, 255})
                           : (right ? Rgb{0, 255, 0} : Rgb{255, 0, 0});
    EXPECT_EQ(model.vertices[i].colour, wanted) << i;
  }
}

TEST(ObjectMesh, OfNothingIsEmpty) {
  const Link link;
  const ObjectModel model = objectModel({&link}, {Pose::Identity()});
  EXPECT_TRUE(model.vertices.empty());
  EXPECT_TRUE(model.triangles.empty());
  EXPECT_EQ(model.diameter, 0.0);
}

TEST(LargestDistance, IsThatOfBruteForce) {
  std::mt19937 random(5);
  for (const int count : {1, 2, 3, 17, 40, 500}) {
    for (int i = 0; i < 5; ++i) {
      std::vector<Eigen::Vector3d> points;
      for (int j = 0; j < count; ++j) points.push_back(test::randomPoint(random, 1.0));
      EXPECT_DOUBLE_EQ(largestDistance(points), bruteForceDiameter(points)) << count;
      for (Eigen::Vector3d& point : points) point.normalize();  // on a sphere
      EXPECT_DOUBLE_EQ(largestDistance(points), bruteForceDiameter(points)) << count;
    }
  }
}

TEST(LargestDistance, OfASphereIsThatOfBruteForce) {
  const auto sphere = sphereMesh(0.37);
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& p : sphere->positions) points.push_back(p.cast<double>());
  EXPECT_DOUBLE_EQ(largestDistance(points), bruteForceDiameter(points));
}

TEST(LargestDistance, OfManyPointsOnASphereIsFoundAtOnce) {
  std::mt19937 random(6);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 30000; ++i) points.push_back(test::randomPoint(random, 1.0).normalized());
  const double distance = largestDistance(points);
  EXPECT_GT(distance, 2.0 - 1e-3);
  EXPECT_LE(distance, 2.0 + 1e-12);
}

TEST(LargestDistance, OfEqualPointsIsNothing) {
  EXPECT_EQ(largestDistance(std::vector<Eigen::Vector3d>(100, {1, 2, 3})), 0.0);
  EXPECT_EQ(largestDistance({}), 0.0);
}

}  // namespace object_mesh_test
}  // namespace synthetic_dataset::world

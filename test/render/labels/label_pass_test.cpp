#include <cmath>

#include <gtest/gtest.h>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace label_pass_test {

using synthetic_dataset::test::boxMesh;
using synthetic_dataset::test::Stage;

const CameraModel kCamera(160, 120, {130.0, 131.0, 80.2, 59.6}, 0.05, 100.0);

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

Eigen::Vector3d vectorAt(const cv::Mat& image, int v, int u) {
  const auto& value = image.at<cv::Vec3f>(v, u);
  return Eigen::Vector3f(value.val).cast<double>();
}

LabelImages labelsOf(const Stage& stage, const LabelPass& pass, const CameraModel& camera = kCamera,
                     const Pose& X_WC = Pose::Identity()) {
  Renderer renderer({}, stage.links(), {});
  return renderer.labels({camera, X_WC}, stage.poses(), pass);
}

TEST(LabelPass, MakesOnlyWhatItIsAskedFor) {
  Stage stage;
  stage.addBox({1, 1, 1}, at(0, 0, 3), 0);

  const LabelImages labels = labelsOf(stage, {stage.all()});

  EXPECT_FALSE(labels.ids.empty());
  EXPECT_FALSE(labels.depth.empty());
  EXPECT_TRUE(labels.links.empty());
  EXPECT_TRUE(labels.normals.empty());
  EXPECT_TRUE(labels.range.empty());
}

TEST(LabelPass, IdsAndDepthsAreTheSameWhateverElseIsAskedFor) {
  Stage stage;
  stage.addBox({1, 0.5, 0.7}, makePose({0.2, 0.1, 2}, Eigen::Quaterniond(0.9, 0.3, 0.1, 0.2)), 0);
  Renderer renderer({}, stage.links(), {});
  const View view{kCamera, Pose::Identity()};

  const LabelImages plain = renderer.labels(view, stage.poses(), {stage.all()});
  const LabelImages full = renderer.labels(view, stage.poses(), {stage.all(), true, true, true});

  EXPECT_EQ(cv::norm(plain.ids, full.ids, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(plain.depth, full.depth, cv::NORM_INF), 0.0);
}

TEST(LabelPass, LinksTellTheLinksOfOneObjectApart) {
  Stage stage;
  stage.addBox({0.1, 0.1, 0.1}, at(0, 0, 9), -1);
  stage.addBox({0.5, 0.5, 0.1}, at(-0.5, 0, 2), 0);
  stage.addBox({0.5, 0.5, 0.1}, at(0.5, 0, 2), 0);

  const LabelImages labels = labelsOf(stage, {stage.all(), true});

  EXPECT_EQ(labels.ids.at<int>(60, 48), 1);
  EXPECT_EQ(labels.ids.at<int>(60, 112), 1);
  EXPECT_EQ(labels.links.at<int>(60, 48), 2);
  EXPECT_EQ(labels.links.at<int>(60, 112), 3);
  EXPECT_EQ(labels.links.at<int>(60, 80), 1) << "the world's have a link too";
  EXPECT_EQ(labels.links.at<int>(5, 5), 0);
}

TEST(LabelPass, NormalsOfABoardAreItsOwn) {
  const Pose X_WB = makePose({0.1, -0.2, 3}, Eigen::Quaterniond(0.95, 0.2, -0.15, 0.1));
  const Pose X_WC = makePose({0.1, 0.2, 0.3}, Eigen::Quaterniond(0.98, 0.02, 0.1, -0.05));
  Stage stage;
  stage.addBox({30, 30, 0.1}, X_WB, 0);

  const LabelImages labels = labelsOf(stage, {stage.all(), false, true}, kCamera, X_WC);

  const Eigen::Vector3d wanted = -(X_WC.inverse() * X_WB).linear().col(2);
  for (int v = 0; v < 120; v += 7) {
    for (int u = 0; u < 160; u += 7) {
      EXPECT_LT((vectorAt(labels.normals, v, u) - wanted).norm(), 1e-5) << u << ", " << v;
    }
  }
}

TEST(LabelPass, NormalsOfASpherePointFromItsCentre) {
  const Eigen::Vector3d centre(0.3, -0.2, 2.5);
  Stage stage;
  stage.addMesh(world::sphereMesh(0.8), at(0.3, -0.2, 2.5), 0, {});

  const LabelImages labels = labelsOf(stage, {stage.all(), false, true});

  const Intrinsics& k = kCamera.intrinsics();
  int count = 0;
  double worst_inside = 1.0;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      const Eigen::Vector3d found = vectorAt(labels.normals, v, u);
      if (labels.ids.at<int>(v, u) == 0) {
        EXPECT_EQ(found.norm(), 0.0);
        continue;
      }
      const double z = static_cast<double>(labels.depth.at<float>(v, u));
      const Eigen::Vector3d p((u - k.cx) / k.fx * z, (v - k.cy) / k.fy * z, z);
      EXPECT_NEAR(found.norm(), 1.0, 1e-5);
      EXPECT_LT(found.dot(p), 1e-5 * p.norm()) << "towards the camera";
      const Eigen::Vector3d wanted = (p - centre).normalized();
      if (wanted.dot(p.normalized()) < -0.1)
        worst_inside = std::min(worst_inside, found.dot(wanted));
      EXPECT_GT(found.dot(wanted), 0.98) << "by the outline too";
      ++count;
    }
  }
  EXPECT_GT(count, 3000);
  EXPECT_GT(worst_inside, std::cos(0.01));
}

TEST(LabelPass, NormalsFaceTheCameraWhereTheMeshsPointInwards) {
  auto inside_out = std::make_shared<world::Mesh>(*boxMesh({1, 1, 1}));
  for (Eigen::Vector3f& normal : inside_out->normals) normal = -normal;
  Stage stage;
  stage.addMesh(inside_out, at(0, 0, 3), 0, {});

  const LabelImages labels = labelsOf(stage, {stage.all(), false, true});

  EXPECT_LT((vectorAt(labels.normals, 60, 80) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-5);
}

TEST(LabelPass, NormalsOfTheBackOfASheetFaceTheCamera) {
  world::Material sheet;
  sheet.double_sided = true;
  Stage stage;
  stage.addMesh(world::planeMesh({0, 0, 1}, {2, 2}), at(0, 0, 3), 0, sheet);

  const LabelImages labels = labelsOf(stage, {stage.all(), false, true});

  EXPECT_LT((vectorAt(labels.normals, 60, 80) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-5);
}

TEST(LabelPass, RangeIsTheDistanceFromTheCamera) {
  Stage stage;
  stage.addBox({20, 20, 2}, at(0, 0, 4), 0);

  const LabelImages labels = labelsOf(stage, {stage.all(), false, false, true});

  const Intrinsics& k = kCamera.intrinsics();
  const auto wanted = [&](int v, int u) {
    return 3.0 * Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0).norm();
  };
  for (const auto& [u, v] : {std::pair{0, 0}, {159, 0}, {80, 60}, {30, 119}}) {
    EXPECT_NEAR(static_cast<double>(labels.range.at<float>(v, u)), wanted(v, u), 1e-5);
  }
}

/// A fisheye in a large cube of six links, so that everything it sees is known.
TEST(LabelPass, HoldsAllRoundAFisheye) {
  const CameraModel& camera = test::kFisheye190.camera;
  world::Material wall;
  wall.double_sided = true;
  Stage stage;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d size(6, 6, 6);
      size[axis] = 0.2;
      Eigen::Vector3d place = Eigen::Vector3d::Zero();
      place[axis] = side * 3.1;
      stage.addBox(size, makePose(place, Eigen::Quaterniond::Identity()), 0, wall);
    }
  }

  const LabelImages labels = labelsOf(stage, {stage.all(), true, true, true}, camera);

  int behind = 0;
  int blurred = 0;  // near an edge of the cube, the nearest drawn pixel may be on the next wall
  int count = 0;
  for (int v = 0; v < camera.height(); v += 3) {
    for (int u = 0; u < camera.width(); u += 3) {
      const auto ray = camera.ray({u, v});
      if (!ray) {
        EXPECT_EQ(labels.links.at<int>(v, u), 0);
        continue;
      }
      ++count;
      Eigen::Index axis = 0;
      const double distance = 3.0 / ray->cwiseAbs().maxCoeff(&axis);
      const double side = (*ray)[axis] > 0.0 ? 1.0 : -1.0;
      if (labels.links.at<int>(v, u) != 2 * axis + (side > 0.0 ? 2 : 1)) {
        ++blurred;
        continue;
      }
      const double z = static_cast<double>(labels.depth.at<float>(v, u));
      EXPECT_NEAR(static_cast<double>(labels.range.at<float>(v, u)), distance, 0.02);
      EXPECT_NEAR(z, distance * ray->z(), 0.02);
      EXPECT_LT((vectorAt(labels.normals, v, u) + side * Eigen::Vector3d::Unit(axis)).norm(), 1e-5);
      if (z < 0.0) ++behind;
    }
  }
  EXPECT_GT(behind, 100);
  EXPECT_LT(blurred, count / 200);
}

}  // namespace label_pass_test
}  // namespace synthetic_dataset::render

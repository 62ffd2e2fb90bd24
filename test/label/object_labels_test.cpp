#include "label/object_labels.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/error_messages.h"

namespace synthetic_dataset::label {
namespace object_labels_test {

const CameraModel kCamera(640, 480, {500, 500, 319.5, 239.5}, 0.1, 100.0);

/// A cube of 1 m.
ObjectShape cube() {
  ObjectShape shape;
  shape.name = "cube";
  shape.class_text = "4";
  shape.class_name = "box";
  shape.id = "7";
  shape.class_id = 4;
  shape.instance = 2;
  shape.keypoints_O = {{0, 0, 0}};
  shape.cuboid_O = {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) shape.bounding_shape_O.emplace_back(x, y, z);
    }
  }
  return shape;
}

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

TEST(LabelObject, GivesPosesInBothFrames) {
  // The camera looks along the global +x from (1, 2, 3): optical z = x, optical x = -y.
  Eigen::Matrix3d R_GC;
  R_GC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Pose X_GC = makePose({1, 2, 3}, Eigen::Quaterniond(R_GC));
  const SceneObject object = labelObject(cube(), at(5, 1.5, 3.25), X_GC, kCamera);
  EXPECT_TRUE(object.X_CO->translation().isApprox(Eigen::Vector3d(0.5, -0.25, 4)));
  EXPECT_TRUE(object.X_GO->translation().isApprox(Eigen::Vector3d(5, 1.5, 3.25)));
  EXPECT_EQ(object.name, "cube");
  EXPECT_EQ(object.class_name, "box");
  EXPECT_EQ(object.class_text, "4");
  EXPECT_EQ(object.id, "7");
  EXPECT_EQ(object.class_id, 4);
  EXPECT_EQ(object.instance, 2);
  EXPECT_DOUBLE_EQ(object.distance(), Eigen::Vector3d(0.5, -0.25, 4).norm());
  EXPECT_EQ(object.cuboid_O.size(), Eigen::Vector3d(1, 1, 1));
}

TEST(LabelObject, GivesKeypointsTheirPlaceAndDepth) {
  const SceneObject object = labelObject(cube(), at(0.3, -0.6, 3), Pose::Identity(), kCamera);
  ASSERT_EQ(object.keypoints.size(), 1U);
  ASSERT_TRUE(object.keypoints[0].pixel);
  EXPECT_NEAR(object.keypoints[0].pixel->x(), 319.5 + 0.3 / 3 * 500, 1e-9);
  EXPECT_NEAR(object.keypoints[0].pixel->y(), 239.5 - 0.6 / 3 * 500, 1e-9);
  EXPECT_NEAR(object.keypoints[0].depth, 3.0, 1e-12);
}

TEST(LabelObject, KeypointsMayBeOffTheImageAndHaveNoPixelBehindTheCamera) {
  const auto keypointAt = [](const Pose& X_GO) {
    return labelObject(cube(), X_GO, Pose::Identity(), kCamera).keypoints.at(0);
  };
  const Keypoint beside = keypointAt(at(-2.0, 0, 3));
  EXPECT_TRUE(beside.pixel);
  const Keypoint behind = keypointAt(at(0, 0, -3));
  EXPECT_FALSE(behind.pixel);
  EXPECT_NEAR(behind.depth, -3.0, 1e-12);
}

TEST(LabelObject, LooseBoxIsRoundTheProjectedShape) {
  const SceneObject object = labelObject(cube(), at(0, 0, 3), Pose::Identity(), kCamera);
  ASSERT_TRUE(object.loose_box);
  EXPECT_NEAR(object.loose_box->left, 319.5 - 0.5 / 2.5 * 500, 1e-9);
  EXPECT_NEAR(object.loose_box->bottom, 239.5 + 0.5 / 2.5 * 500, 1e-9);
  EXPECT_TRUE(object.inView(kCamera));
}

TEST(LabelObject, IsInViewWhileAnyAreaOfItsBoxIs) {
  const auto inView = [](double x) {
    return labelObject(cube(), at(x, 0, 3), Pose::Identity(), kCamera).inView(kCamera);
  };
  // The near face's left edge meets the image's right edge (639.5) at x - 0.5 = 320 / 500 * 2.5;
  // the far face's at x - 0.5 = 320 / 500 * 3.5, which is reached last.
  EXPECT_TRUE(inView(0.5 + 2.24 - 1e-6));
  EXPECT_FALSE(inView(0.5 + 2.24 + 1e-6));
}

TEST(LabelObject, BehindTheCameraThereIsNoBox) {
  const SceneObject object = labelObject(cube(), at(0, 0, -3), Pose::Identity(), kCamera);
  EXPECT_FALSE(object.loose_box);
  EXPECT_FALSE(object.inView(kCamera));
}

TEST(LabelObject, NotInTheSceneItHasNothingThatFollowsFromAPose) {
  const SceneObject object = labelObject(cube(), std::nullopt, Pose::Identity(), kCamera);
  EXPECT_FALSE(object.X_GO || object.X_CO || object.loose_box);
  EXPECT_TRUE(object.dropped);
  ASSERT_EQ(object.keypoints.size(), 1U) << "as many as in other scenes";
  EXPECT_FALSE(object.keypoints[0].pixel);
  EXPECT_EQ(object.bounding_shape_O.size(), 8U);
  EXPECT_EQ(test::messagesOf([&] { (void)object.distance(); }),
            std::vector<std::string>{"'cube' is not in the scene, and so at no distance"});
}

TEST(LabelObject, AroundTheCameraTheBoxCoversTheImage) {
  const SceneObject object = labelObject(cube(), at(0, 0, 0), Pose::Identity(), kCamera);
  ASSERT_TRUE(object.loose_box);
  EXPECT_TRUE(object.inView(kCamera));
  EXPECT_LT(object.loose_box->left, -0.5);
  EXPECT_GT(object.loose_box->right, 639.5);
}

}  // namespace object_labels_test
}  // namespace synthetic_dataset::label

#include "synthetic_dataset/camera_model.h"

#include <random>

#include <gmock/gmock.h>
#include <opencv2/calib3d.hpp>

#include "support/error_messages.h"
#include "support/random_poses.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace camera_model_test {

using ::testing::HasSubstr;

const Intrinsics kIntrinsics{554.38, 560.1, 321.7, 238.2};
const CameraModel kCamera(640, 480, kIntrinsics, 0.05, 100.0);

TEST(CameraModel, ProjectsAsOpenCvDoes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> depth(0.06, 50.0);
  std::vector<cv::Point3d> points;
  for (int i = 0; i < 1000; ++i) {
    const double z = depth(random);
    const Eigen::Vector3d p = test::randomPoint(random, 2.0 * z);
    points.emplace_back(p.x(), p.y(), z);
  }
  const cv::Matx33d k(kIntrinsics.fx, 0, kIntrinsics.cx, 0, kIntrinsics.fy, kIntrinsics.cy, 0, 0,
                      1);
  std::vector<cv::Point2d> truth;
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), k, cv::noArray(), truth);

  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto pixel = kCamera.project({points[i].x, points[i].y, points[i].z});
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), truth[i].x, 1e-6);
    EXPECT_NEAR(pixel->y(), truth[i].y, 1e-6);
  }
}

TEST(CameraModel, ProjectsNothingBeforeTheNearPlane) {
  EXPECT_FALSE(kCamera.project({0, 0, 0.049}));
  EXPECT_FALSE(kCamera.project({0, 0, -1}));
  EXPECT_TRUE(kCamera.project({0, 0, 0.05}));
}

TEST(CameraModel, BoundsHoldAllProjectedPoints) {
  const auto box = kCamera.projectedBounds({{0, 0, 1}, {0.1, -0.2, 2}, {-0.3, 0.1, 1}});
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->left, 321.7 - 0.3 * 554.38, 1e-9);
  EXPECT_NEAR(box->right, 321.7 + 0.05 * 554.38, 1e-9);
  EXPECT_NEAR(box->top, 238.2 - 0.1 * 560.1, 1e-9);
  EXPECT_NEAR(box->bottom, 238.2 + 0.1 * 560.1, 1e-9);
}

TEST(CameraModel, BoundsOfAShapeThroughTheCameraAreThoseOfThePartInFront) {
  // A rod from 1 m behind the camera to 1 m ahead, beside it: in front it runs from the picture's
  // right (far beyond the edge, at the near plane) to its end at z = 1. Nothing is mirrored.
  const auto box = kCamera.projectedBounds({{0.5, 0.0, -1.0}, {0.5, 0.0, 1.0}});
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->left, 321.7 + 0.5 * 554.38, 1e-9);
  EXPECT_NEAR(box->right, 321.7 + 0.5 / 0.05 * 554.38, 1e-6);
}

TEST(CameraModel, BoundsOfAClippedShapeHoldEveryPointOfItsHull) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < 8; ++i) corners.push_back(test::randomPoint(random, 1.0));
    const auto box = kCamera.projectedBounds(corners);
    for (int i = 0; i < 500; ++i) {  // random points of the hull: weights that sum up to 1
      Eigen::Vector3d inside = Eigen::Vector3d::Zero();
      double sum = 0.0;
      for (const Eigen::Vector3d& corner : corners) {
        const double weight = -std::log(1.0 - share(random));
        inside += weight * corner;
        sum += weight;
      }
      const auto pixel = kCamera.project(inside / sum);
      if (!pixel) continue;
      ASSERT_TRUE(box);
      EXPECT_GE(pixel->x(), box->left - 1e-6);
      EXPECT_LE(pixel->x(), box->right + 1e-6);
      EXPECT_GE(pixel->y(), box->top - 1e-6);
      EXPECT_LE(pixel->y(), box->bottom + 1e-6);
    }
  }
}

TEST(CameraModel, AShapeBehindTheCameraHasNoBounds) {
  EXPECT_FALSE(kCamera.projectedBounds({{0, 0, -1}, {1, 1, -2}}));
}

TEST(CameraModel, RefusesWhatIsNoCamera) {
  const auto make = [](int width, Intrinsics k, double near, double far) {
    return [=] { return CameraModel(width, 480, k, near, far); };
  };
  EXPECT_THAT(test::messagesOf(make(0, kIntrinsics, 0.1, 10)),
              testing::ElementsAre(HasSubstr("0 x 480")));
  EXPECT_THAT(test::messagesOf(make(640, {0, 500, 320, 240}, 0.1, 10)),
              testing::ElementsAre(HasSubstr("fx")));
  EXPECT_THAT(test::messagesOf(make(640, {500, NAN, 320, 240}, 0.1, 10)),
              testing::ElementsAre(HasSubstr("fy")));
  EXPECT_THAT(test::messagesOf(make(640, kIntrinsics, 10, 1)),
              testing::ElementsAre(HasSubstr("near")));
}

}  // namespace camera_model_test
}  // namespace synthetic_dataset

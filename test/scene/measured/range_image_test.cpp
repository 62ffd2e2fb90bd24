#include "scene/measured/range_image.h"

#include <gmock/gmock.h>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace synthetic_dataset::scene {
namespace range_image_test {

CameraModel camera(int width, int height, double focal) {
  return {width, height, {focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)}, 0.05, 100.0};
}

/// The range at which a pixel's ray meets a wall at z = `depth` in the camera's frame.
double rangeOfWall(const CameraModel& of, const cv::Point& pixel, double depth) {
  const Eigen::Vector3d ray = *of.ray({static_cast<double>(pixel.x), static_cast<double>(pixel.y)});
  return depth / ray.z();
}

TEST(RangeImage, OfTheSameCameraIsItsDepthPixelByPixel) {
  const CameraModel eye = camera(40, 30, 35.0);
  cv::Mat_<float> depth(30, 40, 2.0F);
  depth(7, 11) = 0.0F;
  depth(8, 12) = 1.0F;
  const cv::Mat_<float> ranges = rangesOfDepth(depth, DepthLens(eye), Pose::Identity(), eye);
  EXPECT_EQ(ranges(7, 11), 0.0F) << "a hole is as large as it was";
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (depth(y, x) == 0.0F) continue;
      EXPECT_NEAR(ranges(y, x), rangeOfWall(eye, {x, y}, depth(y, x)), 1e-5);
    }
  }
}

TEST(RangeImage, OfASmallerCameraBesideHasNoHoles) {
  const CameraModel small = camera(40, 30, 17.0);  // sees more than the other
  const CameraModel large = camera(120, 90, 105.0);
  const cv::Mat_<float> wall(30, 40, 2.0F);
  const Pose X_CD = makePose({0.05, 0.0, 0.0}, Eigen::Quaterniond::Identity());
  const cv::Mat_<float> ranges = rangesOfDepth(wall, DepthLens(small), X_CD, large);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 120; ++x) {
      // A depth pixel spans 6 of the picture's pixels, over which the range changes a little.
      EXPECT_NEAR(ranges(y, x), rangeOfWall(large, {x, y}, 2.0), 0.06) << x << ' ' << y;
    }
  }
}

TEST(RangeImage, KeepsWhatIsNearest) {
  const CameraModel eye = camera(40, 30, 35.0);
  const cv::Mat_<float> ranges = rangesOfCloud({{0, 0, 3}, {0, 0, 2}, {0, 0, 4}}, eye);
  EXPECT_NEAR(ranges(15, 20), 2.0, 1e-6);
}

TEST(RangeImage, OfACloudClosesBetweenRingsAndKeepsHoles) {
  const CameraModel eye = camera(200, 200, 100.0);
  std::vector<Eigen::Vector3d> points;  // of a wall 1 m away: every 2 pixels across, 12 down
  for (int y = 10; y < 190; y += 12) {
    for (int x = 10; x < 190; x += 2) {
      if (x > 80 && x < 140) continue;
      points.emplace_back((x - 99.5) / 100.0, (y - 99.5) / 100.0, 1.0);
    }
  }
  const cv::Mat_<float> ranges = rangesOfCloud(points, eye);
  for (int y = 12; y < 180; ++y) {
    for (const int x : {12, 13, 40, 41, 77, 145, 180})
      EXPECT_GT(ranges(y, x), 0.0F) << x << ' ' << y;
    for (const int x : {90, 110, 130}) EXPECT_EQ(ranges(y, x), 0.0F) << "a hole, " << x << ' ' << y;
  }
}

TEST(RangeImage, OfTwoMeasurementsHasTheNearerOne) {
  const cv::Mat first = (cv::Mat_<float>(1, 4) << 1, 0, 3, 0);
  const cv::Mat second = (cv::Mat_<float>(1, 4) << 2, 2, 2, 0);
  const cv::Mat expected = (cv::Mat_<float>(1, 4) << 1, 2, 2, 0);
  EXPECT_EQ(cv::norm(nearestOf(first, second), expected, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(nearestOf({}, second), second, cv::NORM_INF), 0.0);
}

}  // namespace range_image_test
}  // namespace synthetic_dataset::scene

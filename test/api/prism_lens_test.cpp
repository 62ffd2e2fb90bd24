#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset {
namespace prism_lens_test {

const Intrinsics kIntrinsics{610.2, 604.9, 631.7, 362.2};

double uniform(std::mt19937& random, double reach) {
  return std::uniform_real_distribution<double>(-reach, reach)(random);
}

/// A rational polynomial with a thin prism (12 coefficients), and with a tilted sensor (14).
Distortion randomPrism(std::size_t count, std::mt19937& random) {
  std::vector<double> k = {uniform(random, 0.3),  uniform(random, 0.1),  uniform(random, 2e-3),
                           uniform(random, 2e-3), uniform(random, 0.02), uniform(random, 0.1),
                           uniform(random, 0.1),  uniform(random, 0.1)};
  while (k.size() < 12) k.push_back(uniform(random, 5e-3));
  while (k.size() < count) k.push_back(uniform(random, 0.05));
  return makeDistortion("rational_polynomial", k);
}

class PrismLens : public ::testing::TestWithParam<std::size_t> {};

TEST_P(PrismLens, ProjectsAsOpenCvDoesAndItsRaysLeadBack) {
  std::mt19937 random(31);
  int seen = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const Distortion distortion = randomPrism(GetParam(), random);
    const CameraModel camera(1280, 720, kIntrinsics, 0.05, 100.0, distortion);
    std::vector<cv::Point3d> points;
    for (int i = 0; i < 100; ++i) {
      const double z = 0.06 + 10.0 * std::abs(uniform(random, 1.0));
      points.push_back({z * uniform(random, 0.8), z * uniform(random, 0.8), z});
    }
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(
        points, cv::Vec3d(), cv::Vec3d(),
        cv::Matx33d(kIntrinsics.fx, 0, kIntrinsics.cx, 0, kIntrinsics.fy, kIntrinsics.cy, 0, 0, 1),
        coefficientsOf(distortion), pixels);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d p(points[i].x, points[i].y, points[i].z);
      const auto pixel = camera.project(p);
      if (!pixel) continue;
      ++seen;
      EXPECT_NEAR(pixel->x(), pixels[i].x, 1e-6);
      EXPECT_NEAR(pixel->y(), pixels[i].y, 1e-6);
      const auto ray = camera.ray(*pixel);
      ASSERT_TRUE(ray);
      const auto again = camera.project(5.0 * *ray);
      ASSERT_TRUE(again);
      EXPECT_LT((*again - *pixel).norm(), 1e-6);
    }
  }
  EXPECT_GT(seen, 1500) << "of 3000 points";
}

INSTANTIATE_TEST_SUITE_P(Counts, PrismLens, ::testing::Values(std::size_t{12}, std::size_t{14}));

}  // namespace prism_lens_test
}  // namespace synthetic_dataset

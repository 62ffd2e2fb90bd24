#include <cmath>
#include <random>

#include <gtest/gtest.h>
#ifdef HAS_OMNIDIR
#include <opencv2/ccalib/omnidir.hpp>
#endif

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset {
namespace sphere_lens_test {

const Intrinsics kIntrinsics{310.2, 304.9, 331.7, 242.2};

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

CameraModel cameraWith(const std::string& model, const std::vector<double>& coefficients) {
  return CameraModel(640, 480, kIntrinsics, 0.05, 100.0, makeDistortion(model, coefficients));
}

std::vector<double> randomOmni(std::mt19937& random) {
  return {uniform(random, 0.3, 2.2),    uniform(random, -0.2, 0.1),   uniform(random, -0.02, 0.05),
          uniform(random, -2e-3, 2e-3), uniform(random, -2e-3, 2e-3), uniform(random, -1e-2, 1e-2)};
}

Eigen::Vector3d randomPoint(std::mt19937& random) {
  return {uniform(random, -3.0, 3.0), uniform(random, -3.0, 3.0), uniform(random, -1.0, 3.0)};
}

#ifdef HAS_OMNIDIR
TEST(OmnidirectionalLens, ProjectsAsOpenCvsOmnidirDoes) {
  std::mt19937 random(41);
  int seen = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const std::vector<double> k = randomOmni(random);
    const CameraModel camera = cameraWith("omnidir", k);
    const Intrinsics& f = kIntrinsics;
    const cv::Matx33d K(f.fx, k[5] * f.fx, f.cx, 0.0, f.fy, f.cy, 0.0, 0.0, 1.0);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d p = randomPoint(random);
      const auto pixel = camera.project(p);
      if (!pixel || pixel->norm() > 1e5) continue;  // rounding may exceed 1e-6 px there
      ++seen;
      std::vector<cv::Vec2d> truth;
      cv::omnidir::projectPoints(std::vector<cv::Vec3d>{{p.x(), p.y(), p.z()}}, truth, cv::Vec3d(),
                                 cv::Vec3d(), K, k[0], cv::Vec4d(k[1], k[2], k[3], k[4]));
      EXPECT_NEAR(pixel->x(), truth[0][0], 1e-6);
      EXPECT_NEAR(pixel->y(), truth[0][1], 1e-6);
    }
  }
  EXPECT_GT(seen, 2000) << "of 6000 points";
}
#endif

TEST(OmnidirectionalLens, ProjectsAsMeiAndRivesDo) {
  // Equations 1 to 5 of their paper, one step each: onto the sphere, the shift by xi, onto the
  // normalized plane, the distortion, onto the image.
  std::mt19937 random(42);
  int seen = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<double> k = randomOmni(random);
    const CameraModel camera = cameraWith("omni", k);
    const Eigen::Vector3d p = randomPoint(random);
    const auto pixel = camera.project(p);
    if (!pixel) continue;
    ++seen;
    Eigen::Vector3d on_sphere = p.normalized();
    on_sphere.z() += k[0];
    const double x = on_sphere.x() / on_sphere.z();
    const double y = on_sphere.y() / on_sphere.z();
    const double r2 = x * x + y * y;
    const double radial = 1.0 + k[1] * r2 + k[2] * r2 * r2;
    const double u = x * radial + 2.0 * k[3] * x * y + k[4] * (r2 + 2.0 * x * x);
    const double v = y * radial + k[3] * (r2 + 2.0 * y * y) + 2.0 * k[4] * x * y;
    EXPECT_NEAR(pixel->x(), kIntrinsics.fx * (u + k[5] * v) + kIntrinsics.cx, 1e-9);
    EXPECT_NEAR(pixel->y(), kIntrinsics.fy * v + kIntrinsics.cy, 1e-9);
  }
  EXPECT_GT(seen, 30);
}

/// x / (alpha d2 + (1 - alpha) (xi d1 + z)), with d1 = |p| and d2 = |(x, y, xi d1 + z)|.
Eigen::Vector2d doubleSphere(const Eigen::Vector3d& p, double xi, double alpha) {
  const double d1 = p.norm();
  const double d2 = Eigen::Vector3d(p.x(), p.y(), xi * d1 + p.z()).norm();
  const double below = alpha * d2 + (1.0 - alpha) * (xi * d1 + p.z());
  return {kIntrinsics.fx * p.x() / below + kIntrinsics.cx,
          kIntrinsics.fy * p.y() / below + kIntrinsics.cy};
}

/// The largest angle that such a lens sees, from the paper's condition z > -w2 d1.
double endOfSight(double xi, double alpha) {
  const double w1 = alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha;
  const double w2 = (w1 + xi) / std::sqrt(2.0 * w1 * xi + xi * xi + 1.0);
  return std::acos(-w2);
}

TEST(DoubleSphereLens, ProjectsAsThePaperSays) {
  std::mt19937 random(43);
  int seen = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const double xi = uniform(random, -0.4, 0.6);
    const double alpha = uniform(random, 0.3, 0.8);
    const CameraModel camera = cameraWith("ds", {xi, alpha});
    EXPECT_NEAR(camera.largestAngle(), endOfSight(xi, alpha), 1e-6) << xi << ' ' << alpha;
    const Eigen::Vector3d p = randomPoint(random);
    const auto pixel = camera.project(p);
    const bool is_in_sight = std::atan2(p.head<2>().norm(), p.z()) < endOfSight(xi, alpha);
    EXPECT_EQ(pixel.has_value(), is_in_sight) << xi << ' ' << alpha;
    if (!pixel) continue;
    ++seen;
    EXPECT_LT((*pixel - doubleSphere(p, xi, alpha)).norm(), 1e-9);
  }
  EXPECT_GT(seen, 150);
}

TEST(SphereLenses, HaveRaysThatLeadBackToThePoints) {
  std::mt19937 random(44);
  int seen = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const CameraModel camera =
        trial % 2 == 0
            ? cameraWith("omnidirectional", randomOmni(random))
            : cameraWith("double_sphere", {uniform(random, -0.4, 0.6), uniform(random, 0.2, 0.8)});
    const Eigen::Vector3d direction = randomPoint(random).normalized();
    const double angle = std::atan2(direction.head<2>().norm(), direction.z());
    const auto pixel = camera.project(2.0 * direction);
    if (!pixel || angle > 0.98 * camera.largestAngle()) continue;
    ++seen;
    const auto ray = camera.ray(*pixel);
    ASSERT_TRUE(ray) << trial;
    EXPECT_LT((*ray - direction).norm(), 1e-8) << trial;
  }
  EXPECT_GT(seen, 150);
}

TEST(SphereLenses, SeeBesideTheCameraAndMeasureNearnessByTheDistance) {
  const CameraModel camera = cameraWith("ds", {0.2, 0.6});
  EXPECT_FALSE(camera.hasNearPlane());
  EXPECT_TRUE(camera.project({1.0, 0.0, -0.05}));
  EXPECT_FALSE(camera.project({0.03, 0.0, 0.03}));
}

TEST(SphereLenses, HaveAFieldOfViewOfTheirKind) {
  const CameraModel camera = cameraWith("omni", {1.0, 0.1, 0.0, 0.0, 0.0});
  // With xi = 1 the lens is stereographic: the radius is tan(angle / 2).
  EXPECT_NEAR(*camera.radiusAt(1.2), std::tan(0.6), 1e-12);
  EXPECT_NEAR(camera.angleAt(std::tan(0.6)), 1.2, 1e-12);
  EXPECT_FALSE(cameraWith("omni", {2.0, 0, 0, 0, 0}).radiusAt(2.2)) << "beyond acos(-1 / xi)";
}

TEST(SphereLenses, RefuseWhatNoLensHas) {
  const auto alpha = [] { (void)makeDistortion("ds", {0.1, 1.5}); };
  EXPECT_ANY_THROW(alpha());
  const auto xi = [] { (void)makeDistortion("omni", {-1.5, 0, 0, 0, 0}); };
  EXPECT_ANY_THROW(xi());
  const Distortion outside{DistortionModel::kDoubleSphere, {0.1, -0.5}};
  const auto camera = [&] { (void)CameraModel(640, 480, kIntrinsics, 0.05, 100.0, outside); };
  EXPECT_ANY_THROW(camera());
}

}  // namespace sphere_lens_test
}  // namespace synthetic_dataset

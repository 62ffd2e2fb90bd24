#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <opencv2/calib3d.hpp>

#include "support/error_messages.h"
#include "support/random_poses.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace lens_test {

using ::testing::HasSubstr;

const Intrinsics kIntrinsics{610.2, 604.9, 631.7, 362.2};

CameraModel cameraWith(const Distortion& distortion, double near = 0.05) {
  return CameraModel(1280, 720, kIntrinsics, near, 100.0, distortion);
}

cv::Matx33d matrixOf(const Intrinsics& k) { return {k.fx, 0, k.cx, 0, k.fy, k.cy, 0, 0, 1}; }

/// Where OpenCV projects the points, which are in the camera's frame.
std::vector<cv::Point2d> truth(const Distortion& distortion,
                               const std::vector<cv::Point3d>& points) {
  const auto& c = distortion.coefficients;
  std::vector<cv::Point2d> pixels;
  if (distortion.model == DistortionModel::kEquidistant) {
    const std::vector<double> d(c.begin(), c.begin() + 4);
    cv::fisheye::projectPoints(points, pixels, cv::Vec3d(), cv::Vec3d(), matrixOf(kIntrinsics), d);
  } else {
    const std::vector<double> d(c.begin(), c.end());
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), matrixOf(kIntrinsics), d, pixels);
  }
  return pixels;
}

/// Callers that draw several numbers in one expression use braces, which guarantee the order from
/// left to right with every compiler.
double uniform(std::mt19937& random, double reach) {
  return std::uniform_real_distribution<double>(-reach, reach)(random);
}

Distortion randomDistortion(DistortionModel model, std::mt19937& random) {
  Distortion distortion;
  distortion.model = model;
  auto& c = distortion.coefficients;
  if (model == DistortionModel::kEquidistant) {
    for (std::size_t i = 0; i < 4; ++i) c[i] = uniform(random, 0.02);
    return distortion;
  }
  c = {uniform(random, 0.35), uniform(random, 0.1), uniform(random, 2e-3), uniform(random, 2e-3),
       uniform(random, 0.02)};
  if (model == DistortionModel::kRationalPolynomial) {
    for (std::size_t i = 5; i < 8; ++i) c[i] = uniform(random, 0.1);
  }
  return distortion;
}

class Lens : public ::testing::TestWithParam<DistortionModel> {};

TEST_P(Lens, ProjectsAsOpenCvDoes) {
  std::mt19937 random(11);
  int seen = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const Distortion distortion = randomDistortion(GetParam(), random);
    const CameraModel camera = cameraWith(distortion);
    std::vector<cv::Point3d> points;
    for (int i = 0; i < 200; ++i) {
      const double z = 0.06 + 10.0 * std::abs(uniform(random, 1.0));
      points.push_back({z * uniform(random, 1.2), z * uniform(random, 1.2), z});
    }
    const std::vector<cv::Point2d> pixels = truth(distortion, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto pixel = camera.project({points[i].x, points[i].y, points[i].z});
      if (!pixel) continue;
      ++seen;
      EXPECT_NEAR(pixel->x(), pixels[i].x, 1e-6);
      EXPECT_NEAR(pixel->y(), pixels[i].y, 1e-6);
    }
  }
  EXPECT_GT(seen, 3000) << "of 6000 points";
}

TEST_P(Lens, RaysLeadBackToThePoints) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 30; ++trial) {
    const CameraModel camera = cameraWith(randomDistortion(GetParam(), random));
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d direction =
          Eigen::Vector3d{uniform(random, 1.2), uniform(random, 1.2), 1.0}.normalized();
      const auto pixel = camera.project(5.0 * direction);
      if (!pixel) continue;
      const auto ray = camera.ray(*pixel);
      ASSERT_TRUE(ray);
      // Near the rim of a lens, the pixel hardly depends on the direction: there only the
      // reprojection is checked.
      const auto again = camera.project(5.0 * *ray);
      ASSERT_TRUE(again);
      EXPECT_LT((*again - *pixel).norm(), 1e-6);
      if (std::acos(direction.z()) < 0.95 * camera.largestAngle()) {
        EXPECT_LT(ray->cross(direction).norm(), 1e-9);
      }
    }
  }
}

TEST_P(Lens, ShowsNoPlaceTwice) {
  // As the angle from the axis grows, so does the pixel's distance from the centre; past the
  // lens's largest angle there are no pixels.
  std::mt19937 random(13);
  for (int trial = 0; trial < 100; ++trial) {
    Distortion distortion = randomDistortion(GetParam(), random);
    for (double& c : distortion.coefficients) c *= 3.0;
    const CameraModel camera = cameraWith(distortion, 1e-6);
    const double turn = uniform(random, 3.14);
    double last = -1.0;
    bool ended = false;
    for (double angle = 0.001; angle < 3.13; angle += 0.01) {
      const auto pixel = camera.project(
          {std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)});
      if (!pixel) ended = true;
      if (!pixel) continue;
      EXPECT_FALSE(ended) << "the lens goes dark and sees again at " << angle;
      const double out = std::hypot((pixel->x() - kIntrinsics.cx) / kIntrinsics.fx,
                                    (pixel->y() - kIntrinsics.cy) / kIntrinsics.fy);
      EXPECT_GT(out, last) << "folds back at " << angle;
      last = out;
    }
  }
}

/// How far a pixel lies outside the image; the farther it is, the less exact bounds may be.
double distanceOutside(const CameraModel& camera, const Eigen::Vector2d& p) {
  return std::max({-p.x(), p.x() - camera.width(), -p.y(), p.y() - camera.height(), 0.0});
}

TEST_P(Lens, BoundsHoldTheWholeHullTightly) {
  std::mt19937 random(14);
  for (int trial = 0; trial < 60; ++trial) {
    const CameraModel camera = cameraWith(randomDistortion(GetParam(), random));
    std::vector<Eigen::Vector3d> corners;
    const Eigen::Vector3d centre{uniform(random, 1.0), uniform(random, 1.0), 1.2};
    for (int i = 0; i < 8; ++i) corners.push_back(centre + test::randomPoint(random, 1.0));
    const auto box = camera.projectedBounds(corners);
    std::optional<Box> dense;
    const auto look = [&](const Eigen::Vector3d& p) {
      const auto pixel = camera.project(p);
      if (!pixel) return;
      ASSERT_TRUE(box);
      const double slack = 0.05 + 1e-3 * distanceOutside(camera, *pixel);
      EXPECT_GE(pixel->x(), box->left - slack);
      EXPECT_LE(pixel->x(), box->right + slack);
      EXPECT_GE(pixel->y(), box->top - slack);
      EXPECT_LE(pixel->y(), box->bottom + slack);
      if (!dense) dense = Box{pixel->x(), pixel->y(), pixel->x(), pixel->y()};
      dense->left = std::min(dense->left, pixel->x());
      dense->right = std::max(dense->right, pixel->x());
    };
    for (const Eigen::Vector3d& a : corners) {
      for (const Eigen::Vector3d& b : corners) {
        for (int i = 0; i <= 100; ++i) look(a + 0.01 * i * (b - a));
      }
    }
    const bool all_seen = std::all_of(corners.begin(), corners.end(), [&](const auto& p) {
      return camera.project(p) && p.z() > 0.3;
    });
    if (!all_seen || !box) continue;
    EXPECT_NEAR(dense->left, box->left, 1.0);
    EXPECT_NEAR(dense->right, box->right, 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Lens,
                         ::testing::Values(DistortionModel::kPlumbBob,
                                           DistortionModel::kRationalPolynomial,
                                           DistortionModel::kEquidistant));

Distortion equidistant(double cutoff = 3.14159265) {
  return {DistortionModel::kEquidistant, {0, 0, 0, 0}, cutoff};
}

TEST(Fisheye, SeesBesideAndBehindTheCamera) {
  const CameraModel camera = cameraWith(equidistant());
  const auto beside = camera.project({2.0, 0.0, 0.0});
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->x(), kIntrinsics.cx + kIntrinsics.fx * 1.5707963267948966, 1e-9);
  const auto behind = camera.project({1.0, 0.0, -1.0});
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->x(), kIntrinsics.cx + kIntrinsics.fx * 0.75 * 3.14159265358979, 1e-6);
}

TEST(Fisheye, MeasuresNearnessByTheDistance) {
  const CameraModel camera = cameraWith(equidistant(), 0.5);
  EXPECT_TRUE(camera.project({0.6, 0.0, 0.1}));
  EXPECT_FALSE(camera.project({0.3, 0.0, 0.3}));
}

TEST(Fisheye, IsDarkBeyondItsCutoffAngle) {
  const CameraModel camera = cameraWith(equidistant(1.0));
  EXPECT_TRUE(camera.project({std::sin(0.99), 0.0, std::cos(0.99)}));
  EXPECT_FALSE(camera.project({std::sin(1.01), 0.0, std::cos(1.01)}));
  EXPECT_TRUE(camera.ray({kIntrinsics.cx + 0.99 * kIntrinsics.fx, kIntrinsics.cy}));
  EXPECT_FALSE(camera.ray({kIntrinsics.cx + 1.01 * kIntrinsics.fx, kIntrinsics.cy}));
}

TEST(Fisheye, HasBoundsOfAWallThatPassesTheCamera) {
  // From ahead to behind, 1 m to the right.
  const CameraModel camera = cameraWith(equidistant());
  const auto box = camera.projectedBounds({{1, -0.1, 2}, {1, 0.1, 2}, {1, -0.1, -2}, {1, 0.1, -2}});
  ASSERT_TRUE(box);
  const double far_end = std::atan2(1.0, -2.0);  // halfway along the edge, which bulges
  EXPECT_NEAR(box->right, kIntrinsics.cx + kIntrinsics.fx * far_end, 0.05);
  EXPECT_LT(box->left, kIntrinsics.cx + kIntrinsics.fx * 0.47);
}

TEST(Fisheye, InsideOfAShapeSeesItAllAround) {
  const CameraModel camera = cameraWith(equidistant(1.5));
  const auto box = camera.projectedBounds({{-1, -1, -1},
                                           {1, -1, -1},
                                           {-1, 1, -1},
                                           {1, 1, -1},
                                           {-1, -1, 1},
                                           {1, -1, 1},
                                           {-1, 1, 1},
                                           {1, 1, 1}});
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->right, kIntrinsics.cx + kIntrinsics.fx * 1.5, 0.01);
  EXPECT_NEAR(box->top, kIntrinsics.cy - kIntrinsics.fy * 1.5, 0.01);
}

TEST(Barrel, EndsWhereItWouldFoldBack) {
  // r (1 - 0.3 r^2) is greatest at r = 1 / sqrt(0.9).
  const CameraModel camera = cameraWith({DistortionModel::kPlumbBob, {-0.3}});
  EXPECT_NEAR(std::tan(camera.largestAngle()), 1.0 / std::sqrt(0.9), 1e-6);
  EXPECT_FALSE(camera.project({1.06, 0.0, 1.0}));
  EXPECT_FALSE(camera.projectedBounds({{3, 3, 1}, {4, 3, 1}, {3, 4, 1}}));
}

/// Its image coordinates are so large that no piece of an outline ever counts as straight.
TEST(Barrel, OfCoefficientsThatAreLargeBeyondMeasureComesToAnEnd) {
  for (const double k1 : {1e300, 1e150, -1e300, 1e12}) {
    const CameraModel camera = cameraWith({DistortionModel::kPlumbBob, {k1}});
    (void)camera.projectedBounds({{-1, -1, 2}, {1, -1, 2}, {1, 1, 3}, {-1, 1, 3}, {0.1, 0.2, 5}});
    const CameraModel tangential = cameraWith({DistortionModel::kPlumbBob, {0.0, 0.0, k1}});
    (void)tangential.projectedBounds({{-1, -1, 2}, {1, -1, 2}, {1, 1, 3}});
  }
}

TEST(CameraModel, RefusesADistortionThatIsNoNumber) {
  EXPECT_THAT(test::messagesOf([] {
                cameraWith({DistortionModel::kPlumbBob, {NAN}});
              }),
              testing::ElementsAre(HasSubstr("coefficients should be finite")));
  EXPECT_THAT(test::messagesOf([] { cameraWith(equidistant(4.0)); }),
              testing::ElementsAre(HasSubstr("cutoff")));
}

}  // namespace lens_test
}  // namespace synthetic_dataset

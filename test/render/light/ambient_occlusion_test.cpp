#include "render/light/ambient_occlusion.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/lens_cases.h"

namespace synthetic_dataset::render {
namespace ambient_occlusion_test {

using Eigen::Vector3d;

const cv::Size kImage(320, 240);
const Intrinsics kPinhole{260.0, 260.0, 159.5, 119.5};
constexpr double kFloor = 1.31;  // [m] below the camera, which looks along the floor
constexpr double kWall = 4.0;    // [m] before it

/// A floor and a wall, where y is down and z forward.
struct Corner {
  /// The distance from a point along a ray to the first of the two; infinite if it hits neither.
  static double distance(const Vector3d& from, const Vector3d& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    const double to_floor = (kFloor - from.y()) / ray.y();
    const double to_wall = (kWall - from.z()) / ray.z();
    if (to_floor > 1e-9 && from.z() + to_floor * ray.z() <= kWall) nearest = to_floor;
    if (to_wall > 1e-9 && from.y() + to_wall * ray.y() <= kFloor) {
      nearest = std::min(nearest, to_wall);
    }
    return nearest;
  }
  static bool isWall(const Vector3d& p) { return p.z() > kWall - 1e-9; }
  static Vector3d normal(const Vector3d& p) {
    return isWall(p) ? Vector3d(0, 0, -1) : Vector3d(0, -1, 0);
  }
};

/// A camera's view of the corner.
struct Seen {
  explicit Seen(const cv::Mat& rays = {})
      : occluders{cv::Mat(kImage, CV_32FC1), {cv::Point(), kImage}, kImage, kPinhole, rays},
        normals(kImage, CV_16UC4),
        points(kImage, CV_64FC3) {
    for (int v = 0; v < kImage.height; ++v) {
      for (int u = 0; u < kImage.width; ++u) {
        Vector3d ray((u - kPinhole.cx) / kPinhole.fx, (v - kPinhole.cy) / kPinhole.fy, 1.0);
        if (!rays.empty()) {
          const auto& r = rays.at<cv::Vec3f>(v, u);
          ray = {double{r[0]}, double{r[1]}, double{r[2]}};
        }
        const double depth = Corner::distance({0, 0, 0}, ray);
        occluders.depth.at<float>(v, u) = static_cast<float>(depth);
        const Vector3d p = depth * ray;
        points.at<cv::Vec3d>(v, u) = {p.x(), p.y(), p.z()};
        const Vector3d n = Corner::normal(p);
        constexpr std::uint16_t kMinusOne = 0xBC00;  // as a 16-bit float
        normals.at<cv::Vec4w>(v, u) = {0, n.y() < 0 ? kMinusOne : std::uint16_t{0},
                                       n.z() < 0 ? kMinusOne : std::uint16_t{0}, 0};
      }
    }
  }

  [[nodiscard]] cv::Mat open(const cv::Rect& place) const {
    return ambientVisibility(occluders, normals(place), place,
                             cv::Mat(place.size(), CV_8UC1, cv::Scalar(255)));
  }
  [[nodiscard]] cv::Mat open() const { return open({cv::Point(), kImage}); }

  Occluders occluders;
  cv::Mat normals;
  cv::Mat points;
};

/// The openness by rays in all directions; the farther off a ray's hit is, the less it counts.
double openByRays(const Vector3d& p, const Vector3d& normal) {
  constexpr double kRadius = 0.4;
  constexpr double kFading = 0.615;
  std::mt19937 random(3);
  std::normal_distribution<double> normally;
  double open = 0.0;
  constexpr int kRays = 4000;
  for (int i = 0; i < kRays; ++i) {
    // Weighted by the cosine of the angle to the normal.
    const Vector3d unit =
        Vector3d(normally(random), normally(random), normally(random)).normalized();
    const Vector3d ray = (normal + unit).normalized();
    const double distance = Corner::distance(p + 1e-6 * normal, ray);
    open += 1.0 - std::clamp((kRadius - distance) / (kFading * kRadius), 0.0, 1.0);
  }
  return open / kRays;
}

/// Compares the openness in the middle column with that by rays.
void expectThatOfRays(const Seen& seen) {
  const cv::Mat open = seen.open();
  double worst = 0.0;
  double sum = 0.0;
  double darkest = 1.0;
  int count = 0;
  for (int v = 20; v < 230; ++v) {
    const auto& p = seen.points.at<cv::Vec3d>(v, 160);
    const Vector3d point(p[0], p[1], p[2]);
    const double expected = openByRays(point, Corner::normal(point));
    const double difference = std::abs(static_cast<double>(open.at<float>(v, 160)) - expected);
    worst = std::max(worst, difference);
    sum += difference;
    darkest = std::min(darkest, expected);
    ++count;
  }
  EXPECT_LT(darkest, 0.6);
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(sum / count, 0.02);
}

TEST(Openness, IsThatOfRaysInACorner) { expectThatOfRays(Seen()); }

TEST(Openness, IsThatOfRaysThroughALens) {
  const CameraModel lens(kImage.width, kImage.height, kPinhole, 0.05, 100.0,
                         test::kPlumbBob.camera.distortion());
  cv::Mat rays(kImage, CV_32FC3);
  for (int v = 0; v < kImage.height; ++v) {
    for (int u = 0; u < kImage.width; ++u) {
      const Vector3d ray = lens.ray({u, v}).value();
      rays.at<cv::Vec3f>(v, u) = {static_cast<float>(ray.x()), static_cast<float>(ray.y()),
                                  static_cast<float>(ray.z())};
    }
  }
  expectThatOfRays(Seen(rays));
}

TEST(Openness, IsWholeOnAPlaneFarFromAllElse) {
  const Seen seen;
  const cv::Mat open = seen.open();
  EXPECT_GT(open.at<float>(20, 160), 0.99F);   // on the wall
  EXPECT_GT(open.at<float>(235, 160), 0.99F);  // on the floor
}

TEST(Openness, IsTheSameInAnyPartOfThePicture) {
  const Seen seen;
  const cv::Mat whole = seen.open();
  for (const cv::Rect& place : {cv::Rect(37, 180, 11, 9), cv::Rect(0, 100, 320, 3),
                                cv::Rect(317, 220, 3, 20), cv::Rect(151, 221, 1, 1)}) {
    // A margin of two pixels around each place is requested as well.
    const cv::Rect around = cv::Rect(place.tl() - cv::Point(2, 2), place.br() + cv::Point(2, 2)) &
                            cv::Rect(cv::Point(), kImage);
    const cv::Mat part = seen.open(around)(place - around.tl());
    EXPECT_EQ(cv::norm(part, whole(place), cv::NORM_INF), 0.0) << place;
  }
}

TEST(Openness, DependsOnNothingFartherAwayThanItsReach) {
  Seen seen;
  const cv::Mat before = seen.open();
  const cv::Mat reaches = occlusionReaches(seen.occluders);
  const cv::Rect changed(200, 150, 12, 20);
  seen.occluders.depth(changed) *= 0.96;
  const cv::Mat after = seen.open();
  int differs = 0;
  for (int v = 0; v < kImage.height; ++v) {
    for (int u = 0; u < kImage.width; ++u) {
      if (before.at<float>(v, u) == after.at<float>(v, u)) continue;
      ++differs;
      const int du = std::max({changed.x - u, u - (changed.br().x - 1), 0});
      const int dv = std::max({changed.y - v, v - (changed.br().y - 1), 0});
      if (du == 0 && dv == 0) continue;
      EXPECT_LE(std::max(du, dv), reaches.at<float>(v, u)) << u << ", " << v;
      EXPECT_LE(std::max(du, dv), occlusionReach(kImage));
    }
  }
  EXPECT_GT(differs, 300);
}

}  // namespace ambient_occlusion_test
}  // namespace synthetic_dataset::render

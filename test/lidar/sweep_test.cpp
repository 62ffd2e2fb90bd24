#include "lidar/sweep.h"

#include <algorithm>
#include <string>

#include <Eigen/Eigenvalues>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lidar/scanned_hall.h"

namespace synthetic_dataset::lidar {
namespace sweep_test {

using test::kSweepTime;
using test::ScannedHall;

/// The greatest distance of a wall's points from a plane that is fitted to them.
double bending(const Cloud& cloud, std::uint16_t world_class, bool corrected) {
  std::vector<Eigen::Vector3d> points;
  for (const CloudPoint& point : cloud.points) {
    if (point.world_class != world_class) continue;
    points.push_back((corrected ? point.position_at_stamp_S : point.position_S).cast<double>());
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) middle += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) spread += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  double farthest = 0.0;
  for (const Eigen::Vector3d& p : points) {
    farthest = std::max(farthest, std::abs((p - middle).dot(axes.eigenvectors().col(0))));
  }
  return farthest;
}

TEST(Sweep, HasStraightWallsOnlyWithoutItsOwnMotion) {
  ScannedHall hall(0);
  const auto frames = hall.frames();
  const Cloud cloud = test::cloudIn(hall, test::exactModel(16, 1024), frames);
  constexpr std::uint16_t kNorth = 4;
  EXPECT_LT(bending(cloud, kNorth, true), 0.001);
  EXPECT_GT(bending(cloud, kNorth, false), 0.01);
}

TEST(Sweep, LabelsPointsByWhatTheyAreOf) {
  ScannedHall hall(4);
  const auto frames = hall.frames();
  const Cloud cloud = test::cloudIn(hall, test::exactModel(16, 512), frames);
  ASSERT_EQ(cloud.points_of_objects.size(), 4U);
  std::vector<std::int64_t> counts(4, 0);
  for (const CloudPoint& point : cloud.points) {
    EXPECT_EQ(point.part, 2 * point.instance);
    EXPECT_EQ(point.class_number, point.instance > 0 ? 1 : 0);
    EXPECT_EQ(point.world_class == 0, point.instance > 0);
    if (point.instance > 0) ++counts[point.instance - std::size_t{1}];
  }
  EXPECT_EQ(counts, cloud.points_of_objects);
  EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 0);
}

TEST(Sweep, HasTheSameBytesEachTime) {
  constexpr std::size_t kPadding = 2;  // at a point's end
  const auto bytesOf = [] {
    ScannedHall hall(8);
    LidarModel model = test::exactModel(16, 512);
    model.noise = 0.02;
    model.dropout = 0.1;
    const auto frames = hall.frames();
    const Cloud cloud = test::cloudIn(hall, model, frames);
    std::string bytes;
    for (const CloudPoint& point : cloud.points) {
      bytes.append(reinterpret_cast<const char*>(&point), sizeof point - kPadding);
    }
    return bytes;
  };
  EXPECT_EQ(bytesOf(), bytesOf());
}

TEST(Sweep, MeasuresWithNoiseAndInSteps) {
  ScannedHall hall(0);
  const auto frames = hall.frames(false);
  const Cloud exact = test::cloudIn(hall, test::exactModel(16, 512), frames);
  LidarModel model = test::exactModel(16, 512);
  model.noise = 0.05;
  model.resolution = 0.01;
  ScannedHall again(0);
  const Cloud noisy = test::cloudIn(again, model, frames);
  ASSERT_EQ(exact.points.size(), noisy.points.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const double range = noisy.points[i].position_S.cast<double>().norm();
    EXPECT_NEAR(std::remainder(range, 0.01), 0.0, 1e-5);
    const double error = range - exact.points[i].position_S.cast<double>().norm();
    squares += error * error;
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(exact.points.size())), 0.05, 0.003);
}

TEST(Sweep, LosesTheShareOfReturnsThatIsSet) {
  ScannedHall hall(0);
  const auto frames = hall.frames(false);
  LidarModel model = test::exactModel(16, 512);
  const auto all = static_cast<double>(test::cloudIn(hall, model, frames).points.size());
  model.dropout = 0.25;
  ScannedHall again(0);
  EXPECT_NEAR(static_cast<double>(test::cloudIn(again, model, frames).points.size()) / all, 0.75,
              0.02);
}

TEST(Sweep, SeesDarkAndSlantedSurfacesLessFar) {
  const auto sizeAt = [](double reach) {
    ScannedHall hall(0);
    LidarModel model = test::exactModel(16, 512);
    model.reach_at_tenth = reach;
    const auto frames = hall.frames(false);
    return test::cloudIn(hall, model, frames).points.size();
  };
  EXPECT_EQ(sizeAt(100.0), sizeAt(50.0));
  EXPECT_LT(sizeAt(2.0), sizeAt(50.0));
  EXPECT_EQ(sizeAt(0.1), 0U);
}

TEST(Sweep, HasNormalsTowardsTheScanner) {
  ScannedHall hall(6);
  const auto frames = hall.frames();
  for (const CloudPoint& point : test::cloudIn(hall, test::exactModel(16, 256), frames).points) {
    EXPECT_NEAR(point.normal_S.norm(), 1.0F, 1e-5F);
    EXPECT_LE(point.normal_S.dot(point.position_S), 1e-4F);
    EXPECT_GE(point.intensity, 0.0F);
    EXPECT_LE(point.intensity, 1.0F);
  }
}

}  // namespace sweep_test
}  // namespace synthetic_dataset::lidar

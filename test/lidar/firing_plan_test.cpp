#include "lidar/firing_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace synthetic_dataset::lidar {
namespace firing_plan_test {

using std::chrono::milliseconds;

TEST(FiringPlan, LooksAheadAtTheStamp) {
  const FiringPlan plan(*modelOf("OS1-64"));
  EXPECT_EQ(plan.columns(), 1024);
  EXPECT_EQ(plan.rings(), 64);
  EXPECT_EQ(plan.length(), milliseconds(100));
  EXPECT_EQ(plan.columnTime(512), Duration(0));
  const Eigen::Vector3d ahead = plan.direction(512, 31);
  EXPECT_GT(ahead.x(), 0.99);
  EXPECT_NEAR(ahead.y(), 0.0, 1e-9);
}

TEST(FiringPlan, TurnsClockwiseFromBehindLikeVelodynes) {
  const FiringPlan plan(*modelOf("VLP-16"));
  EXPECT_EQ(plan.columns(), 1808);
  EXPECT_LT(plan.direction(0, 0).x(), -0.9);
  EXPECT_GT(plan.direction(452, 0).y(), 0.9);  // a quarter later: to the left
  EXPECT_NEAR(plan.direction(0, 15).z(), std::sin(15.0 * M_PI / 180.0), 1e-12);
}

TEST(FiringPlan, FiresLowerAndUpperLasersInTurns) {
  const FiringPlan plan(*modelOf("VLP-16"));
  const double period = toSeconds(plan.length()) / plan.columns();
  EXPECT_NEAR(plan.share(0) * period, 0.0, 1e-12);
  EXPECT_NEAR(plan.share(8) * period, 2.304e-6, 1e-9);
  EXPECT_NEAR(plan.share(1) * period, 4.608e-6, 1e-9);
  EXPECT_NEAR(plan.share(15) * period, 15 * 2.304e-6, 1e-9);
}

TEST(FiringPlan, HasBothEndsOfLessThanATurn) {
  const FiringPlan plan(*modelOf("UTM-30LX"));
  EXPECT_NEAR(std::atan2(plan.direction(0, 0).y(), plan.direction(0, 0).x()), -0.75 * M_PI, 1e-9);
  EXPECT_NEAR(std::atan2(plan.direction(1080, 0).y(), plan.direction(1080, 0).x()), 0.75 * M_PI,
              1e-9);
  EXPECT_EQ(plan.length(), Duration(18'750'000));  // three quarters of a turn
}

TEST(FiringPlan, StaysWithinItsLength) {
  for (const std::string& name : modelNames()) {
    LidarModel model = *modelOf(name);
    model.rate = 7.3;
    const FiringPlan plan(model);
    EXPECT_LE(plan.columnTime(plan.columns()) - plan.columnTime(0), plan.length()) << name;
    for (int column = 0; column < plan.columns(); ++column) {
      EXPECT_LE(plan.columnTime(column), plan.columnTime(column + 1)) << name;
    }
  }
}

TEST(LidarModels, HaveTheirDataSheetsElevations) {
  constexpr double kDegree = M_PI / 180.0;
  EXPECT_NEAR(modelOf("HDL-64E")->elevations.front(), -24.3333 * kDegree, 1e-5);
  EXPECT_NEAR(modelOf("HDL-64E")->elevations[31], -8.8333 * kDegree, 1e-5);
  EXPECT_NEAR(modelOf("HDL-64E")->elevations[32], -8.3333 * kDegree, 1e-5);
  EXPECT_NEAR(modelOf("HDL-64E")->elevations.back(), 2.0 * kDegree, 1e-9);
  EXPECT_NEAR(modelOf("HDL-32E")->elevations.front(), -30.6667 * kDegree, 1e-5);
  EXPECT_EQ(modelOf("OS1-128")->elevations.size(), 128U);
  EXPECT_FALSE(modelOf("VLP-17").has_value());
}

}  // namespace firing_plan_test
}  // namespace synthetic_dataset::lidar

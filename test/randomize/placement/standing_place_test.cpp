#include "randomize/placement/standing_place.h"

#include <memory>

#include <gmock/gmock.h>

#include "randomize/placement/solid_boxes.h"

namespace synthetic_dataset::randomize {
namespace standing_place_test {

using test::floorBox;
using test::SolidBox;
using ::testing::HasSubstr;
using world::at;
using world::turnedAt;

/// A box whose bottom is 0.3 m below its frame's origin.
const Cuboid kBox{{-0.4, -0.2, -0.3}, {0.4, 0.2, 0.7}};

class StandingPlaceTest : public ::testing::Test {
 protected:
  void build(const std::vector<SolidBox>& standing, const std::vector<world::Model>& props = {}) {
    world = test::worldOf(standing, {}, props);
    surroundings = std::make_unique<Surroundings>(*world);
  }

  [[nodiscard]] PoseOrReason stand(double x, double y, double heading = 0.0) {
    return StandingPlace(*surroundings, options).at({x, y}, heading, kBox);
  }

  [[nodiscard]] Pose pose(double x, double y, double heading = 0.0) {
    const PoseOrReason found = stand(x, y, heading);
    if (const auto* X_GO = std::get_if<Pose>(&found)) return *X_GO;
    ADD_FAILURE() << "they " << std::get<std::string>(found);
    return Pose::Identity();
  }

  [[nodiscard]] std::string reason(double x, double y, double heading = 0.0) {
    const PoseOrReason found = stand(x, y, heading);
    const auto* text = std::get_if<std::string>(&found);
    return text == nullptr ? "none" : *text;
  }

  std::unique_ptr<world::World> world;
  std::unique_ptr<Surroundings> surroundings;
  SurfaceOptions options;
};

TEST_F(StandingPlaceTest, IsOnTheFloor) {
  build({floorBox()});
  const Pose X_GO = pose(1.0, -2.0, 0.7);
  EXPECT_TRUE(X_GO.translation().isApprox(Eigen::Vector3d(1.0, -2.0, 0.3), 1e-6));
  const Eigen::Vector3d ahead = X_GO.linear() * Eigen::Vector3d::UnitX();
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d(std::cos(0.7), std::sin(0.7), 0.0), 1e-6));
  EXPECT_NEAR(X_GO.linear()(2, 2), 1.0, 1e-9);
}

TEST_F(StandingPlaceTest, IsOnATable) {
  build({floorBox(), {"table", {2, 2, 0.1}, at(3, 0, 0.75)}});
  EXPECT_NEAR(pose(3.0, 0.0).translation().z(), 0.8 + 0.3, 1e-6);
  EXPECT_NEAR(pose(0.0, 0.0).translation().z(), 0.3, 1e-6);
}

TEST_F(StandingPlaceTest, IsBelowWhatIsTooHigh) {
  build({floorBox(), {"roof", {20, 20, 0.1}, at(0, 0, 2.1)}});
  EXPECT_NEAR(pose(1.0, 1.0).translation().z(), 0.3, 1e-6);
  options.highest = 2.2;
  EXPECT_NEAR(pose(1.0, 1.0).translation().z(), 2.15 + 0.3, 1e-6);
}

TEST_F(StandingPlaceTest, MayBeDeepDown) {
  SolidBox ground = floorBox();
  ground.X_GB = at(0, 0, -50.5);
  build({ground});
  EXPECT_NEAR(pose(1.0, 1.0).translation().z(), -50.0 + 0.3, 1e-5);
}

TEST_F(StandingPlaceTest, LiesInTheRampsPlane) {
  // 0.3 rad, up towards some direction between x and y.
  const SolidBox ramp{"ramp", {10, 10, 0.4}, turnedAt({1, 2, 0}, 0.3, {-0.6, 0.8, 0})};
  build({ramp});
  for (const double heading : {-2.0, 0.0, 0.4, 3.0}) {
    const Pose X_RO = ramp.X_GB.inverse() * pose(1.7, 1.5, heading);
    for (const Eigen::Vector3d& corner : kBox.corners()) {
      // The ramp's top is 0.2 m above its middle: the box's bottom is there, its top 1 m above.
      const double height = corner.z() < 0.0 ? 0.2 : 1.2;
      EXPECT_NEAR((X_RO * corner).z(), height, 1e-6) << heading;
    }
  }
}

TEST_F(StandingPlaceTest, TurnsAboutTheRampsNormal) {
  const SolidBox ramp{"ramp", {10, 10, 0.4}, turnedAt({0, 0, 0}, 0.3, {0, 1, 0})};
  build({ramp});
  const Pose X_AB = pose(0.5, 0.5, 0.2).inverse() * pose(0.5, 0.5, 1.3);
  const Eigen::Matrix3d expected =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_TRUE(X_AB.linear().isApprox(expected, 1e-6));
  // Without a heading, the object faces along x, up or down the slope.
  const Eigen::Vector3d ahead = pose(0.5, 0.5).linear() * Eigen::Vector3d::UnitX();
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d(std::cos(0.3), 0, -std::sin(0.3)), 1e-6));
}

TEST_F(StandingPlaceTest, IsNoneOnASteepSurface) {
  build({{"ramp", {10, 10, 0.4}, turnedAt({0, 0, 0}, 0.3, {0, 1, 0})}});
  options.steepest = 0.31;
  EXPECT_EQ(reason(0.5, 0.5), "none");
  options.steepest = 0.29;
  EXPECT_EQ(reason(0.5, 0.5), "would have stood on something steep");
}

TEST_F(StandingPlaceTest, IsNoneOverNothing) {
  build({floorBox()});
  EXPECT_EQ(reason(25.0, 0.0), "had nothing below to stand on");
}

TEST_F(StandingPlaceTest, IsNoneOverAnEdge) {
  // The floor ends at x = 20; the box reaches 0.4 m ahead and 0.2 m to each side.
  build({floorBox()});
  EXPECT_EQ(reason(19.59, 0.0), "none");
  EXPECT_THAT(reason(19.61, 0.0), HasSubstr("stuck out over an edge"));
  EXPECT_EQ(reason(19.79, 0.0, M_PI / 2), "none");
  EXPECT_THAT(reason(19.81, 0.0, M_PI / 2), HasSubstr("stuck out over an edge"));
}

TEST_F(StandingPlaceTest, IsNoneAcrossAStepDown) {
  build({floorBox(), {"step", {10, 10, 0.08}, at(-5, 0, 0.0)}});  // 0.04 m high, up to x = 0
  EXPECT_NEAR(pose(-0.2, 0.0).translation().z(), 0.04 + 0.3, 1e-6);
  options.unevenness = 0.03;
  EXPECT_THAT(reason(-0.2, 0.0), HasSubstr("across a step"));
}

TEST_F(StandingPlaceTest, IsOnAPlaneHoweverEvenItHasToBe) {
  build({floorBox()});
  options.unevenness = 0.0;
  EXPECT_EQ(reason(1.0, 1.0), "none");
}

TEST_F(StandingPlaceTest, IsOnAPropWhereItHasComeToRest) {
  const SolidBox crate{"crate", {2, 2, 0.5}, at(0, 0, 1.0)};
  build({floorBox()}, {crate.model()});
  EXPECT_NEAR(pose(0.0, 0.0).translation().z(), 1.25 + 0.3, 1e-6);
  world->settleProps(std::chrono::seconds(5));
  EXPECT_NEAR(pose(0.0, 0.0).translation().z(), 0.5 + 0.3, 0.01);
}

TEST_F(StandingPlaceTest, IsNeverOnAnObject) {
  world = test::worldOf({floorBox()}, {{"alpha", {1, 1, 1}, at(0, 0, 0.5)}});
  surroundings = std::make_unique<Surroundings>(*world);
  EXPECT_NEAR(pose(0.0, 0.0).translation().z(), 0.3, 1e-6);
}

}  // namespace standing_place_test
}  // namespace synthetic_dataset::randomize

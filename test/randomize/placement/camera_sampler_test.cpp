#include "randomize/placement/camera_sampler.h"

#include <cmath>
#include <memory>

#include <gmock/gmock.h>

#include "randomize/placement/solid_boxes.h"
#include "support/random_poses.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace camera_sampler_test {

using base::Distribution;
using Eigen::Vector3d;
using test::SolidBox;
using ::testing::AllOf;
using ::testing::HasSubstr;
using world::at;

// --- lookingAt ---

TEST(LookingAt, HasTheAxesOfAnOpticalFrame) {
  // From 3 m before the origin and 1 m up, looking straight ahead.
  const Pose X_GC = lookingAt({-3, 0, 1}, {5, 0, 1}, 0.0);
  EXPECT_TRUE(X_GC.translation().isApprox(Vector3d(-3, 0, 1)));
  EXPECT_TRUE(X_GC.linear().col(0).isApprox(Vector3d(0, -1, 0))) << "x is right";
  EXPECT_TRUE(X_GC.linear().col(1).isApprox(Vector3d(0, 0, -1))) << "y is down";
  EXPECT_TRUE(X_GC.linear().col(2).isApprox(Vector3d(1, 0, 0))) << "z is ahead";
}

TEST(LookingAt, HasTheAimInTheMiddleAndTheHorizonLevel) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3d from = test::randomPoint(random, 5.0);
    const Vector3d aim = test::randomPoint(random, 5.0);
    const Pose X_GC = lookingAt(from, aim, 0.0);
    const Vector3d aim_C = X_GC.inverse() * aim;
    EXPECT_TRUE(aim_C.isApprox(Vector3d(0, 0, (aim - from).norm()), 1e-9));
    EXPECT_NEAR(X_GC.linear()(2, 0), 0.0, 1e-12) << "to the right is level";
    EXPECT_LT(X_GC.linear()(2, 1), 0.0) << "down is down";
    EXPECT_NEAR(X_GC.linear().determinant(), 1.0, 1e-9);
  }
}

TEST(LookingAt, RollsClockwise) {
  // A camera turned clockwise by a quarter turn has the right end of the horizon at its top.
  const Pose X_GC = lookingAt({0, 0, 0}, {1, 0, 0}, M_PI / 2);
  EXPECT_TRUE(X_GC.linear().col(0).isApprox(Vector3d(0, 0, -1), 1e-12));
  EXPECT_TRUE(X_GC.linear().col(1).isApprox(Vector3d(0, 1, 0), 1e-12));
  const Vector3d tilted_right = lookingAt({0, 0, 0}, {1, 0, 0}, 0.2).linear().col(0);
  EXPECT_NEAR(tilted_right.z(), -std::sin(0.2), 1e-12) << "its right side goes down";
}

TEST(LookingAt, MayBeStraightDownOrUp) {
  for (const double height : {2.0, -2.0}) {
    const Pose X_GC = lookingAt({1, 1, height}, {1, 1, 0}, 0.0);
    EXPECT_TRUE((X_GC.inverse() * Vector3d(1, 1, 0)).isApprox(Vector3d(0, 0, 2), 1e-12));
    EXPECT_TRUE(X_GC.linear().isUnitary(1e-12));
    EXPECT_NEAR(X_GC.linear().determinant(), 1.0, 1e-12);
  }
}

// --- CameraSampler ---

class CameraSamplerTest : public ::testing::Test {
 protected:
  void build(const std::vector<SolidBox>& standing, const std::vector<SolidBox>& objects = {}) {
    world = test::worldOf(standing, objects);
    surroundings = std::make_unique<Surroundings>(*world);
    if (objects.empty()) return;
    world->advanceTo(Stamp(1), [&](int object, Stamp) {
      return world::ObjectPose(objects[static_cast<std::size_t>(object)].X_GB);
    });
  }

  [[nodiscard]] Pose sample(std::int64_t scene, const std::string& group = "camera",
                            std::uint64_t seed = 1) {
    if (!world) build({});
    return sampled(scene, group, seed).X_GC;
  }

  [[nodiscard]] SampledPose sampled(std::int64_t scene, const std::string& group = "camera",
                                    std::uint64_t seed = 1) {
    return CameraSampler(config, group, *world, *surroundings, seed).sample(scene, targets);
  }

  [[nodiscard]] std::string error() {
    try {
      static_cast<void>(sample(3));
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  }

  /// Whether a point lies ahead, in the middle of the picture.
  static bool isAhead(const Pose& X_GC, const Vector3d& p_G) {
    const Vector3d p_C = X_GC.inverse() * p_G;
    return p_C.z() > 0.0 && p_C.head<2>().norm() < 1e-9 * p_C.z();
  }

  CameraSampling config;
  std::vector<CameraTarget> targets{{"alpha", {1, 2, 0.5}}};
  std::unique_ptr<world::World> world;
  std::unique_ptr<Surroundings> surroundings;
};

TEST_F(CameraSamplerTest, StaysInItsShellAndLooksAtTheTarget) {
  config.distance = Distribution::uniform({2.0}, {4.0});
  config.elevation = Distribution::uniform({0.3}, {0.9});
  config.azimuth = Distribution::uniform({-1.0}, {0.5});
  double nearest = 1e9;
  double farthest = 0.0;
  for (int scene = 0; scene < 500; ++scene) {
    const Pose X_GC = sample(scene);
    const Vector3d seen = X_GC.translation() - targets[0].centre_G;
    const double elevation = std::asin(seen.z() / seen.norm());
    const double azimuth = std::atan2(seen.y(), seen.x());
    ASSERT_TRUE(elevation >= 0.3 - 1e-9 && elevation <= 0.9 + 1e-9) << elevation;
    ASSERT_TRUE(azimuth >= -1.0 - 1e-9 && azimuth <= 0.5 + 1e-9) << azimuth;
    ASSERT_TRUE(isAhead(X_GC, targets[0].centre_G));
    nearest = std::min(nearest, seen.norm());
    farthest = std::max(farthest, seen.norm());
  }
  EXPECT_GE(nearest, 2.0 - 1e-9);
  EXPECT_LT(nearest, 2.1);
  EXPECT_LE(farthest, 4.0 + 1e-9);
  EXPECT_GT(farthest, 3.9);
}

TEST_F(CameraSamplerTest, SeesObjectsOfAllSizesAlikeWithLengthsInSizes) {
  targets = {{"mug", {1, 2, 0.5}, true, 0.1}, {"car", {-4, 0, 0.5}, true, 5.0}};
  config.is_relative_to_size = true;
  config.distance = Distribution::constant({3.0});
  config.aim_offset = Distribution::constant({0, 0, 0.2});
  config.azimuth = Distribution::constant({0.5});
  const auto elevationOfAim = [&](const char* name) {
    config.look_at = name;
    const Pose X_GC = sample(0);
    const CameraTarget& target = targets[name == std::string("car") ? 1 : 0];
    const double distance = (X_GC.translation() - target.centre_G).norm();
    EXPECT_NEAR(distance, 3.0 * target.size, 1e-9) << name;
    EXPECT_TRUE(isAhead(X_GC, target.centre_G + Vector3d(0, 0, 0.2 * distance))) << name;
    return X_GC.linear().col(2).z();
  };
  EXPECT_NEAR(elevationOfAim("mug"), elevationOfAim("car"), 1e-9);
}

TEST_F(CameraSamplerTest, GoesAllTheWayRoundByDefault) {
  std::vector<int> counts(8, 0);
  for (int scene = 0; scene < 2000; ++scene) {
    const Vector3d seen = sample(scene).translation() - targets[0].centre_G;
    const double share = (std::atan2(seen.y(), seen.x()) + M_PI) / (2.0 * M_PI);
    ++counts.at(std::min<std::size_t>(7, static_cast<std::size_t>(8.0 * share)));
  }
  EXPECT_LT(test::chiSquared(counts), 7.0 + 4.0 * std::sqrt(14.0));
}

TEST_F(CameraSamplerTest, StaysInItsBox) {
  config.position_G = Distribution::uniform({-5, -5, 2}, {5, 5, 3}, 3);
  for (int scene = 0; scene < 200; ++scene) {
    const Pose X_GC = sample(scene);
    const Vector3d p_G = X_GC.translation();
    EXPECT_TRUE(std::abs(p_G.x()) <= 5 && std::abs(p_G.y()) <= 5 && p_G.z() >= 2 && p_G.z() <= 3);
    EXPECT_TRUE(isAhead(X_GC, targets[0].centre_G));
  }
}

TEST_F(CameraSamplerTest, LooksPastTheTargetByTheOffset) {
  config.aim_offset = Distribution::constant({0.1, -0.2, 0.3});
  config.distance = Distribution::constant({2.0});
  const Pose X_GC = sample(0);
  EXPECT_TRUE(isAhead(X_GC, targets[0].centre_G + Vector3d(0.1, -0.2, 0.3)));
  EXPECT_NEAR((X_GC.translation() - targets[0].centre_G).norm(), 2.0, 1e-9)
      << "the shell is about the target itself";
}

TEST_F(CameraSamplerTest, Rolls) {
  const Pose level = sample(5);
  config.roll = Distribution::constant({0.4});
  const Pose X_CR = level.inverse() * sample(5);
  EXPECT_TRUE(
      X_CR.linear().isApprox(Eigen::AngleAxisd(0.4, Vector3d::UnitZ()).toRotationMatrix(), 1e-9));
  EXPECT_LT(X_CR.translation().norm(), 1e-12);
}

// --- What the camera looks at ---

TEST_F(CameraSamplerTest, LooksAtAnyOfTheObjects) {
  targets = {{"alpha", {0, 0, 0}}, {"bravo", {9, 0, 0}}, {"gamma", {0, 9, 0}}};
  std::vector<int> counts(3, 0);
  for (int scene = 0; scene < 600; ++scene) {
    const Pose X_GC = sample(scene);
    for (std::size_t i = 0; i < 3; ++i) counts[i] += isAhead(X_GC, targets[i].centre_G) ? 1 : 0;
  }
  EXPECT_EQ(counts[0] + counts[1] + counts[2], 600);
  EXPECT_LT(test::chiSquared(counts), 2.0 + 4.0 * std::sqrt(4.0));
}

TEST_F(CameraSamplerTest, LooksAtTheMiddleOfAll) {
  targets = {{"alpha", {0, 0, 0}}, {"bravo", {9, 0, 3}}, {"gamma", {0, 9, 0}}};
  config.look_at = "all";
  EXPECT_TRUE(isAhead(sample(0), {3, 3, 1}));
}

TEST_F(CameraSamplerTest, LooksAtTheObjectOfAName) {
  targets = {{"alpha", {0, 0, 0}}, {"bravo", {9, 0, 3}}};
  config.look_at = "bravo";
  for (int scene = 0; scene < 10; ++scene) EXPECT_TRUE(isAhead(sample(scene), {9, 0, 3}));
}

TEST_F(CameraSamplerTest, LooksAtAPoint) {
  config.look_at_point_G = Vector3d(7, 7, 7);
  EXPECT_TRUE(isAhead(sample(0), {7, 7, 7}));
}

// --- What the camera keeps clear of ---

TEST_F(CameraSamplerTest, KeepsItsClearanceFromAllThatIsThere) {
  const std::vector<SolidBox> standing = {
      {"cupboard", {1.0, 2.0, 3.0}, world::turnedAt({3, 2, 0.5}, 0.4, {0, 0, 1})},
      {"beam", {0.3, 6.0, 0.3}, world::turnedAt({0, 2, 2.5}, 0.7, {1, 2, 0})}};
  const std::vector<SolidBox> objects = {{"bravo", {0.8, 0.8, 0.8}, at(-0.5, 1.5, 1.2)}};
  build(standing, objects);
  config.clearance = 0.4;
  std::vector<double> least(3, 1e9);
  for (int scene = 0; scene < 1500; ++scene) {
    const Vector3d p_G = sample(scene).translation();
    for (std::size_t i = 0; i < 3; ++i) {
      const SolidBox& box = i < 2 ? standing[i] : objects[0];
      least[i] = std::min(least[i], box.distanceTo(p_G));
    }
  }
  for (const double distance : least) {
    EXPECT_GT(distance, 0.4 - 1e-3);
    EXPECT_LT(distance, 0.5) << "but it comes as near as it may";
  }
}

TEST_F(CameraSamplerTest, NeedsNoClearanceWhereNoneIsAskedFor) {
  build({{"glass", {9, 9, 9}, at(0, 0, 0)}});
  targets[0].centre_G = {0, 0, 0};
  EXPECT_THAT(error(), HasSubstr("were too near 'glass'"));
  config.clearance = 0.0;
  EXPECT_EQ(error(), "none");
}

TEST_F(CameraSamplerTest, IsNeverBehindAWall) {
  const std::vector<SolidBox> walls = {
      {"wall", {0.1, 3.0, 3.0}, world::turnedAt({1.8, 2, 1}, 0.3, {0, 0, 1})},
      {"shelf", {1.5, 0.2, 2.0}, world::turnedAt({1, 1.2, 1}, -0.2, {0, 1, 0})}};
  build(walls);
  config.clearance = 0.0;
  config.elevation = Distribution::uniform({-1.0}, {1.0});
  std::vector<int> octants(8, 0);
  for (int scene = 0; scene < 1000; ++scene) {
    const Pose X_GC = sample(scene);
    for (const SolidBox& wall : walls) {
      SolidBox inner = wall;  // rays along its faces may hit or miss
      inner.size.array() -= 1e-3;
      ASSERT_FALSE(inner.isBetween(X_GC.translation(), targets[0].centre_G)) << scene;
    }
    const Vector3d seen = X_GC.translation() - targets[0].centre_G;
    ++octants[(seen.x() > 0 ? 4U : 0U) + (seen.y() > 0 ? 2U : 0U) + (seen.z() > 0 ? 1U : 0U)];
  }
  EXPECT_GT(octants[3], 200) << "more than an eighth are where no wall is";
}

TEST_F(CameraSamplerTest, MayLookAtAWall) {
  build({{"wall", {0.1, 3.0, 3.0}, at(1.05, 2, 0.5)}});
  config.look_at_point_G = Vector3d(1.0, 2.0, 0.5);  // on its face
  for (int scene = 0; scene < 20; ++scene) {
    EXPECT_LT(sample(scene).translation().x(), 1.0) << "from its own side";
  }
}

TEST_F(CameraSamplerTest, ObjectsDoNotHideOneAnother) {
  build({}, {{"bravo", {0.1, 9, 9}, at(0, 2, 0.5)}});
  config.azimuth = Distribution::constant({M_PI});
  config.distance = Distribution::uniform({2.0}, {3.0});
  EXPECT_LT(sample(0).translation().x(), 0.0);
}

// --- Draws ---

TEST_F(CameraSamplerTest, GivesEachSceneCameraAndSeedAPlaceOfItsOwn) {
  const Pose X_GC = sample(7);
  EXPECT_TRUE(sample(7).matrix() == X_GC.matrix());
  EXPECT_FALSE(sample(8).isApprox(X_GC));
  EXPECT_FALSE(sample(7, "cameras/left").isApprox(X_GC));
  EXPECT_FALSE(sample(7, "camera", 2).isApprox(X_GC));
}

// --- What is impossible ---

TEST_F(CameraSamplerTest, NamesWhatIsInTheWay) {
  build({{"block", {20, 20, 20}, at(0, 0, 0)}});
  config.tries = 30;
  EXPECT_THAT(error(), AllOf(HasSubstr("camera/sample: scene 3: none of 30 places was free: 30 "
                                       "were too near 'block'"),
                             HasSubstr("a smaller clearance would help")));
}

TEST_F(CameraSamplerTest, StandsWhereItIsFreeIfNothingSeesTheTarget) {
  build({{"box", {0.5, 0.5, 0.5}, at(1, 2, 0.5)}});
  config.tries = 30;
  for (int scene = 0; scene < 20; ++scene) {
    const SampledPose found = sampled(scene);
    EXPECT_EQ(found.hidden, "30 would not have seen what they look at");
    EXPECT_TRUE(isAhead(found.X_GC, targets[0].centre_G));
    EXPECT_FALSE(world->obstacleNear(found.X_GC.translation(), config.clearance));
  }
  build({});
  EXPECT_EQ(sampled(3).hidden, "");
}

TEST_F(CameraSamplerTest, NeverStandsWhereItLooks) {
  config.position_G = Distribution::constant({1, 2, 0.5});
  config.tries = 5;
  EXPECT_THAT(error(), HasSubstr("5 would have stood where they look"));
}

}  // namespace camera_sampler_test
}  // namespace synthetic_dataset::randomize

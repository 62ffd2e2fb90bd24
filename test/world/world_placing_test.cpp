/// What the world does for scenes that are independent of one another.

#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synthetic_dataset/errors.h"
#include "world/physics/simple_models.h"
#include "world/world.h"

namespace synthetic_dataset::world {
namespace world_placing_test {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::HasSubstr;

constexpr Stamp kStart = seconds(1000);
const BoxShape kCube{{0.5, 0.5, 0.5}};

/// A motion through the heap.
Pose stir(int object, Stamp time) {
  const double t = toSeconds(time - kStart);
  return turnedAt({std::sin(3 * t) - 0.4 * object, 0.2 * object, 0.25}, t, {0, 0, 1});
}

Pose farAway(int object, Stamp /*time*/) { return at(50.0 + 5.0 * object, 0, 1); }

/// Props in a heap above the ground.
Description heap() {
  std::vector<Model> models = {ground()};
  for (int i = 0; i < 6; ++i) {
    models.push_back(modelOf(
        "prop" + std::to_string(i), BoxShape{{0.3, 0.2, 0.1}},
        turnedAt({0.1 * (i % 3), 0.1 * (i % 2), 0.2 + 0.25 * i}, 0.3 * i, {1, 0.5 * i, 0.2})));
  }
  return descriptionOf(std::move(models));
}

std::vector<MovingObject> twoCubes() { return {modelOf("a", kCube), modelOf("b", kCube)}; }

PhysicsOptions dropping() {
  PhysicsOptions options;
  options.drops_objects = true;
  return options;
}

void expectSameBits(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].matrix() == b[i].matrix()) << i;
  }
}

/// Link poses after a second of stirring from the start.
std::vector<Pose> stirred(World& world) {
  world.advanceTo(kStart, stir);
  world.advanceTo(kStart + milliseconds(500), stir);
  world.advanceTo(kStart + milliseconds(1013), stir);
  return world.linkPoses();
}

/// How high a box's lowest corner is.
double lowestCorner(const Pose& X_WB, const Eigen::Vector3d& size) {
  return X_WB.translation().z() - 0.5 * X_WB.linear().row(2).cwiseAbs().dot(size);
}

template <class Action>
std::string messageOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// --- restart ---

TEST(Restart, GivesTheBitsOfANewWorld) {
  World used(heap(), twoCubes(), {});
  static_cast<void>(stirred(used));
  used.restart();
  World fresh(heap(), twoCubes(), {});
  const std::vector<Pose> as_new = stirred(fresh);
  expectSameBits(stirred(used), as_new);
  EXPECT_FALSE(as_new[1].isApprox(heap().models[1].X_WM, 1e-3)) << "something did move";
}

TEST(Restart, PutsPropsBackAtOnce) {
  World world(heap(), {}, {});
  const std::vector<Pose> before = world.linkPoses();
  static_cast<void>(stirred(world));
  const std::int64_t revision = world.propRevision();
  world.restart();
  expectSameBits(world.linkPoses(), before);
  EXPECT_GT(world.propRevision(), revision);
}

TEST(Restart, SetsTheClockBack) {
  World world(heap(), twoCubes(), {});
  world.advanceTo(kStart, stir);
  EXPECT_THROW(world.advanceTo(kStart - seconds(1), stir), Error);
  world.restart();
  EXPECT_NO_THROW(world.advanceTo(kStart - seconds(1), stir));
  EXPECT_THROW(world.advanceTo(kStart - seconds(2), stir), Error);
}

TEST(Restart, KnowsOfNoOverlapsUntilTheNextStart) {
  World world(descriptionOf({staticModelOf("wall", kCube)}), {modelOf("a", kCube)}, {});
  world.advanceTo(kStart, [](int, Stamp) { return at(0, 0, 0); });
  ASSERT_EQ(world.interpenetrations().size(), 1U);
  world.restart();
  EXPECT_TRUE(world.interpenetrations().empty());
}

// --- settleProps ---

TEST(SettleProps, LaysABoxOnTheFloor) {
  const Eigen::Vector3d size(0.4, 0.3, 0.2);
  World world(descriptionOf({modelOf("box", BoxShape{size}, at(1, 2, 1)), ground()}), {}, {});
  world.settleProps(seconds(5));
  const Pose X_WB = world.linkPoses()[0];
  EXPECT_NEAR(X_WB.translation().z(), 0.1, 0.005);
  EXPECT_NEAR(X_WB.translation().x(), 1.0, 0.005);
  EXPECT_NEAR(X_WB.linear()(2, 2), 1.0, 1e-4);
  world.advanceTo(kStart, farAway);
  world.advanceTo(kStart + seconds(2), farAway);
  EXPECT_TRUE(world.linkPoses()[0].isApprox(X_WB, 2e-3)) << "and there it stays";
}

TEST(SettleProps, IsWhereRestartGoesBackTo) {
  World world(heap(), twoCubes(), {});
  world.settleProps(seconds(5));
  const std::vector<Pose> settled = world.linkPoses();
  EXPECT_LT(settled[1].translation().z(), 0.4);
  static_cast<void>(stirred(world));
  world.restart();
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_TRUE(world.linkPoses()[i].matrix() == settled[i].matrix()) << i;
  }
}

TEST(SettleProps, TakesNoNoticeOfTheObjects) {
  World without(heap(), {}, {});
  World with(heap(), twoCubes(), {});  // both at the origin, in the heap's place
  without.settleProps(seconds(5));
  with.settleProps(seconds(5));
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_TRUE(without.linkPoses()[i].matrix() == with.linkPoses()[i].matrix()) << i;
  }
}

TEST(SettleProps, EndsWithItsTime) {
  World world(descriptionOf({modelOf("box", kCube, at(0, 0, 100))}), {}, {});
  world.settleProps(seconds(1));
  // g t^2 / 2, plus at most the last speed times the length of a step.
  EXPECT_NEAR(world.linkPoses()[0].translation().z(), 100 - 0.5 * 9.81, 0.04);
}

// --- drop ---

TEST(Drop, LaysABoxOnTheFloor) {
  const Eigen::Vector3d size(0.4, 0.3, 0.2);
  World world(descriptionOf({ground()}), {modelOf("a", BoxShape{size})}, dropping());
  const auto X_WO = world.drop({at(1, 2, 0.7)}, seconds(10));
  ASSERT_TRUE(X_WO);
  EXPECT_NEAR((*X_WO)[0]->translation().z(), 0.1, 0.005);
  EXPECT_NEAR((*X_WO)[0]->linear()(2, 2), 1.0, 1e-4);
}

TEST(Drop, LaysATiltedBoxOnOneOfItsSides) {
  const Eigen::Vector3d size(0.4, 0.3, 0.2);
  World world(descriptionOf({ground()}), {modelOf("a", BoxShape{size})}, dropping());
  for (const double angle : {0.5, 1.0, 2.0}) {
    const auto X_WO = world.drop({turnedAt({0, 0, 1}, angle, {1, 2, 0.5})}, seconds(10));
    ASSERT_TRUE(X_WO);
    EXPECT_NEAR(lowestCorner(*(*X_WO)[0], size), 0.0, 0.005) << angle;
    EXPECT_NEAR((*X_WO)[0]->linear().row(2).cwiseAbs().maxCoeff(), 1.0, 1e-3) << angle;
    world.restart();
  }
}

TEST(Drop, LeavesNoTwoBoxesInsideOneAnother) {
  World world(descriptionOf({ground()}), twoCubes(), dropping());
  const auto X_WO = world.drop({at(0, 0, 0.3), at(0.1, 0.05, 0.9)}, seconds(10));
  ASSERT_TRUE(X_WO);
  // Both lie flat, one on top of the other.
  EXPECT_NEAR((*X_WO)[0]->translation().z(), 0.25, 0.005);
  EXPECT_NEAR((*X_WO)[1]->translation().z(), 0.75, 0.01);
}

TEST(Drop, GivesTheSameBitsWhateverWasDroppedBefore) {
  const std::vector<std::optional<Pose>> start = {turnedAt({0, 0, 2.5}, 0.4, {1, 1, 0}),
                                                  at(0.3, 0.1, 3.5)};
  World used(heap(), twoCubes(), dropping());
  World fresh(heap(), twoCubes(), dropping());
  static_cast<void>(used.drop({at(0.2, 0, 2), at(-0.2, 0, 3)}, seconds(10)));
  static_cast<void>(stirred(used));
  used.restart();
  const auto again = used.drop(start, seconds(10));
  const auto first = fresh.drop(start, seconds(10));
  ASSERT_TRUE(again && first);
  expectSameBits({*again->at(0), *again->at(1)}, {*first->at(0), *first->at(1)});
  expectSameBits({used.linkPoses().begin(), used.linkPoses().begin() + 7},
                 {fresh.linkPoses().begin(), fresh.linkPoses().begin() + 7});
}

TEST(Drop, PushesPropsUntilRestart) {
  const Model post = modelOf("post", BoxShape{{0.12, 0.12, 0.8}}, at(0, 0, 0.4));
  World world(descriptionOf({post, ground()}), {modelOf("a", kCube)}, dropping());
  world.settleProps(seconds(5));
  const Pose settled = world.linkPoses()[0];
  // Onto the post's edge: it topples.
  const auto X_WO = world.drop({turnedAt({0.2, 0, 1.4}, 0.6, {0, 1, 0})}, seconds(10));
  ASSERT_TRUE(X_WO);
  const Pose pushed = world.linkPoses()[0];
  EXPECT_LT(pushed.translation().z(), settled.translation().z() - 0.1);
  world.advanceTo(kStart, [&](int, Stamp) { return (*X_WO)[0]; });
  EXPECT_TRUE(world.linkPoses()[0].matrix() == pushed.matrix()) << "scenes begin with it there";
  world.restart();
  EXPECT_TRUE(world.linkPoses()[0].matrix() == settled.matrix());
}

TEST(Drop, LeavesThingsThatStayWhereTheyLie) {
  World world(heap(), twoCubes(), dropping());
  const auto X_WO = world.drop({at(0, 0, 2.5), at(0.3, 0, 3.5)}, seconds(15));
  ASSERT_TRUE(X_WO);
  const auto lying = [&](int object, Stamp) { return (*X_WO)[static_cast<std::size_t>(object)]; };
  world.advanceTo(kStart, lying);
  const std::vector<Pose> before = world.linkPoses();
  world.advanceTo(kStart + seconds(1), lying);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_LT((before[i].translation() - world.linkPoses()[i].translation()).norm(), 0.01) << i;
  }
}

TEST(Drop, GivesUpOnWhatFallsForEver) {
  World world(descriptionOf({}), twoCubes(), dropping());
  EXPECT_EQ(world.drop({at(0, 0, 1), at(2, 0, 1)}, seconds(3)), std::nullopt);
}

TEST(Drop, NeedsACollision) {
  Model ghost = modelOf("ghost", kCube);
  ghost.links[0].collisions.clear();
  EXPECT_THAT(messageOf([&] { World(descriptionOf({ground()}), {ghost}, dropping()); }),
              HasSubstr("object 'ghost': it cannot be dropped, as its model has no collision"));
  EXPECT_NO_THROW(World(descriptionOf({ground()}), {ghost}, {}));
}

// --- obstacleAt ---

class Obstacles : public ::testing::Test {
 protected:
  /// A wall whose face is at x = 1, a prop whose face is at y = 1, and cubes of 0.5 m as objects.
  World world{descriptionOf({staticModelOf("wall", BoxShape{{1, 9, 9}}, at(1.5, 0, 0)),
                             modelOf("crate", BoxShape{{1, 1, 1}}, at(0, 1.5, 0))}),
              twoCubes(),
              {}};
};

TEST_F(Obstacles, AreStaticModels) {
  EXPECT_EQ(world.obstacleAt(0, at(0.77, 0, 0), {}), "wall");
  EXPECT_EQ(world.obstacleAt(0, at(0.73, 0, 0), {}), std::nullopt);
}

TEST_F(Obstacles, AreProps) {
  EXPECT_EQ(world.obstacleAt(1, at(0, 0.77, 0), {}), "crate");
  EXPECT_EQ(world.obstacleAt(1, at(0, 0.73, 0), {}), std::nullopt);
}

TEST_F(Obstacles, AreObjectsBeforeIt) {
  EXPECT_EQ(world.obstacleAt(1, at(0, 0, 0), {at(-0.48, 0, 0)}), "a");
  EXPECT_EQ(world.obstacleAt(1, at(0, 0, 0), {at(-0.52, 0, 0)}), std::nullopt);
  EXPECT_EQ(world.obstacleAt(1, at(0, 0, 0), {}), std::nullopt);
}

TEST_F(Obstacles, CountBeyondTheTolerance) {
  // The tolerance is 0.01 m.
  EXPECT_EQ(world.obstacleAt(0, at(0.759, 0, 0), {}), std::nullopt);
  EXPECT_EQ(world.obstacleAt(0, at(0.761, 0, 0), {}), "wall");
}

TEST_F(Obstacles, ArePropsWhereTheyStandNow) {
  world.advanceTo(kStart, farAway);
  world.advanceTo(kStart + seconds(1), farAway);  // the crate has fallen by five metres
  EXPECT_EQ(world.obstacleAt(0, at(0, 1.5, 0), {}), std::nullopt);
  EXPECT_EQ(world.obstacleAt(0, at(0, 1.5, -4.9), {}), "crate");
  world.restart();
  EXPECT_EQ(world.obstacleAt(0, at(0, 1.5, 0), {}), "crate");
}

TEST_F(Obstacles, AreWhereTheirModelsHaveTheirCollisions) {
  Model lamp = modelOf("lamp", BoxShape{{1, 1, 1}}, at(0, 0, 0));
  lamp.links[0].collisions[0].X_LC = at(0, 0, 3);
  const World hall(descriptionOf({lamp}), {lamp}, {});
  EXPECT_EQ(hall.obstacleNear({0, 0, 0}, 0.1), std::nullopt);
  EXPECT_EQ(hall.obstacleNear({0, 0, 3}, 0.1), "lamp");
  EXPECT_EQ(hall.obstacleAt(0, at(0.9, 0, 0), {}), "lamp");
  EXPECT_EQ(hall.obstacleAt(0, at(0, 0, 1.1), {}), std::nullopt);
}

TEST_F(Obstacles, AreTurnedAsTheObjectIs) {
  // A cube of 0.5 m on its edge is 0.707 m wide.
  EXPECT_EQ(world.obstacleAt(0, at(0.70, 0, 0), {}), std::nullopt);
  EXPECT_EQ(world.obstacleAt(0, turnedAt({0.70, 0, 0}, M_PI / 4, {0, 0, 1}), {}), "wall");
}

TEST_F(Obstacles, AreNearABall) {
  EXPECT_EQ(world.obstacleNear({0.79, 0, 0}, 0.2), std::nullopt);
  EXPECT_EQ(world.obstacleNear({0.81, 0, 0}, 0.2), "wall");
  EXPECT_EQ(world.obstacleNear({0, 0.81, 0}, 0.2), "crate");
  EXPECT_EQ(world.obstacleNear({0, 0.79, 0}, 0.2), std::nullopt);
}

TEST_F(Obstacles, NearABallAreObjectsWhereTheyStandNow) {
  EXPECT_EQ(world.obstacleNear({50, 0, 1}, 0.2), std::nullopt);
  world.advanceTo(kStart, farAway);
  EXPECT_EQ(world.obstacleNear({50, 0.44, 1}, 0.2), "a");
  EXPECT_EQ(world.obstacleNear({55, 0.44, 1}, 0.2), "b");
  EXPECT_EQ(world.obstacleNear({55, 0.46, 1}, 0.2), std::nullopt);
}

TEST_F(Obstacles, NearABallAreRound) {
  // From the crate's edge at x = -0.5, y = 1: 0.3 m and 0.4 m across make 0.5 m.
  EXPECT_EQ(world.obstacleNear({-0.8, 0.6, 0}, 0.49), std::nullopt);
  EXPECT_EQ(world.obstacleNear({-0.8, 0.6, 0}, 0.51), "crate");
}

TEST(Distractor, IsNowhereUntilItIsPlaced) {
  World world(descriptionOf({ground()}), twoCubes(), {}, {modelOf("ball", SphereShape{0.3})});
  world.advanceTo(kStart, farAway);
  const std::size_t ball = world.links().size() - 1;
  ASSERT_EQ(world.links()[ball].role, Role::kDistractor);
  EXPECT_EQ(world.links()[ball].object, -1);
  EXPECT_FALSE(world.presentLinks()[ball]);
  const std::int64_t before = world.propRevision();
  world.placeDistractors({at(1, 2, 3)});
  EXPECT_TRUE(world.presentLinks()[ball]);
  EXPECT_TRUE(world.linkPoses()[ball].matrix() == at(1, 2, 3).matrix());
  EXPECT_GT(world.propRevision(), before);
  EXPECT_EQ(world.obstacleNear({1, 2, 3.4}, 0.2), "ball");
  world.placeDistractors({std::nullopt});
  EXPECT_FALSE(world.presentLinks()[ball]);
  EXPECT_EQ(world.obstacleNear({1, 2, 3.4}, 0.2), std::nullopt);
}

TEST(Distractor, IsKeptClearOfObjectsThatAreThere) {
  World world(descriptionOf({ground()}), twoCubes(), {},
              {modelOf("ball", SphereShape{0.3}), modelOf("box", kCube)});
  world.advanceTo(kStart, farAway);  // a at x = 50, b at x = 55
  EXPECT_EQ(world.obstacleOfDistractor(0, at(50, 0, 1), {}), "a");
  EXPECT_EQ(world.obstacleOfDistractor(0, at(0, 0, -1), {}), "ground");
  EXPECT_EQ(world.obstacleOfDistractor(1, at(0.2, 0, 2), {at(0, 0, 2)}), "ball");
  EXPECT_EQ(world.obstacleOfDistractor(1, at(0.2, 0, 2), {std::nullopt}), std::nullopt);
  world.setPresent({false, true});
  EXPECT_EQ(world.obstacleOfDistractor(0, at(50, 0, 1), {}), std::nullopt);
}

TEST(AbsentObject, IsNotSeenAndInsideOfNothing) {
  World world(descriptionOf({ground()}), twoCubes(), {});
  const auto together = [](int /*object*/, Stamp /*time*/) { return ObjectPose(at(0, 0, 1)); };
  world.advanceTo(kStart, together);
  EXPECT_EQ(world.interpenetrations().size(), 1U);
  EXPECT_TRUE(world.isPresent(0) && world.isPresent(1));
  world.setPresent({true, false});
  EXPECT_TRUE(world.interpenetrations().empty());
  for (std::size_t i = 0; i < world.links().size(); ++i) {
    EXPECT_EQ(world.presentLinks()[i], world.links()[i].object != 1) << i;
  }
  world.setPresent({true, true});
  EXPECT_EQ(world.interpenetrations().size(), 1U);
}

TEST(AbsentObject, DoesNotFall) {
  World world(descriptionOf({ground()}), twoCubes(), dropping());
  world.setPresent({false, true});
  const auto lying = world.drop({at(0, 0, 1), at(0, 0, 1.05)}, seconds(10));
  ASSERT_TRUE(lying.has_value());
  EXPECT_TRUE((*lying)[0]->matrix() == at(0, 0, 1).matrix());
  EXPECT_NEAR((*lying)[1]->translation().z(), 0.25, 0.01);
}

}  // namespace world_placing_test
}  // namespace synthetic_dataset::world

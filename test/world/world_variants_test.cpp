/// Objects of several models, one of which is active at a time.

#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "world/physics/simple_models.h"
#include "world/world.h"

namespace synthetic_dataset::world {
namespace world_variants_test {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Model cube(const std::string& name, double side) {
  return modelOf(name, BoxShape{{side, side, side}});
}

MovingObject smallOrLarge(double small, double large) {
  return MovingObject(std::vector<MovingModel>{cube("one", small), cube("one", large)});
}

/// A cube of 0.2 m or of 2 m, and beside it a cube of 0.4 m that is always the same.
std::vector<MovingObject> objects() { return {smallOrLarge(0.2, 2.0), cube("two", 0.4)}; }

/// A metre apart: only the large variant reaches the other object.
ObjectPose apart(int variant, Stamp /*time*/) {
  return ObjectPose(at(variant == 2 ? 1.0 : 0.0, 0, 2));
}

TEST(WorldVariants, AreLinksOfOneObject) {
  const World world(descriptionOf({}), objects(), {});
  std::vector<std::pair<int, std::size_t>> numbers;
  for (const LinkInstance& link : world.links()) numbers.emplace_back(link.object, link.variant);
  EXPECT_THAT(numbers, ElementsAre(std::pair(0, 0U), std::pair(0, 1U), std::pair(1, 0U)));
  EXPECT_EQ(world.variant(0), 0U);
  EXPECT_EQ(world.variant(1), 0U);
}

TEST(WorldVariants, AreSeenWhileTheyAreActiveAndTheObjectIsPresent) {
  World world(descriptionOf({}), objects(), {});
  EXPECT_THAT(world.presentLinks(), ElementsAre(true, false, true));
  world.setVariants({1, 0});
  EXPECT_EQ(world.variant(0), 1U);
  EXPECT_EQ(world.variant(1), 0U);
  EXPECT_THAT(world.presentLinks(), ElementsAre(false, true, true));
  world.setPresent({false, true});
  EXPECT_THAT(world.presentLinks(), ElementsAre(false, false, true));
  EXPECT_FALSE(world.isPresent(0));
  EXPECT_TRUE(world.isPresent(1));
}

TEST(WorldVariants, AreInsideOfThingsOnlyWhileTheyAreActive) {
  World world(descriptionOf({}), objects(), {});
  world.advanceTo(seconds(1), apart);
  EXPECT_THAT(world.interpenetrations(), IsEmpty());
  EXPECT_FALSE(world.obstacleAt(1, at(0, 0, 2.5), {at(0, 0, 2)}));
  EXPECT_FALSE(world.obstacleNear({0, 0, 2.5}, 0.1));
  world.setVariants({1, 0});
  ASSERT_THAT(world.interpenetrations(), SizeIs(1));
  EXPECT_NEAR(world.interpenetrations()[0].depth, 0.2, 1e-3);
  EXPECT_EQ(world.obstacleAt(1, at(0, 0, 2.5), {at(0, 0, 2)}), "one");
  EXPECT_EQ(world.obstacleNear({0, 0, 2.5}, 0.1), "one");
}

TEST(WorldVariants, StandWhereTheObjectIsEvenWhileTheyAreNotActive) {
  World world(descriptionOf({}), objects(), {});
  world.advanceTo(seconds(1), apart);
  EXPECT_TRUE(world.linkPoses()[1].isApprox(at(0, 0, 2)));
}

/// A ball lies still while an object slides towards it, which only touches it in its large size.
TEST(WorldVariants, PushPropsOnlyWhileTheyAreActive) {
  const auto ballAfter = [](std::size_t variant) {
    World world(descriptionOf({ground(), modelOf("ball", SphereShape{0.1}, at(0.5, 0, 0.1))}),
                {smallOrLarge(0.2, 0.9)}, {});
    world.setVariants({variant});
    const auto sliding = [](int, Stamp time) {
      return ObjectPose(at(0.1 * toSeconds(time), 0, 0.5));
    };
    for (int i = 0; i <= 10; ++i) world.advanceTo(milliseconds(100 * i), sliding);
    return world.linkPoses()[1].translation().x();
  };
  EXPECT_NEAR(ballAfter(0), 0.5, 1e-3);
  EXPECT_GT(ballAfter(1), 0.6);
}

/// The ball lies on an object that stays below it, but whose large variant is only active at times.
TEST(WorldVariants, HoldPropsFromWhenTheyBecomeActiveUntilTheyNoLongerAre) {
  World world(descriptionOf({modelOf("ball", SphereShape{0.1}, at(0, 0, 1.0))}),
              {smallOrLarge(0.01, 1.0)}, {});
  const auto standing = [](int, Stamp) { return ObjectPose(at(0, 0, 0.4)); };
  const auto heightAfter = [&](std::size_t variant, Stamp time) {
    world.setVariants({variant});
    world.advanceTo(time, standing);
    return world.linkPoses()[0].translation().z();
  };
  EXPECT_NEAR(heightAfter(1, seconds(0)), 1.0, 1e-9);
  EXPECT_NEAR(heightAfter(1, seconds(4)), 1.0, 0.01);
  EXPECT_LT(heightAfter(0, seconds(5)), 0.7) << "through where the large one was";
}

/// The same body goes away and comes back, always at the same pose.
TEST(WorldVariants, CanComeBackWhereTheyWere) {
  World world(descriptionOf({modelOf("ball", SphereShape{0.1}, at(0.02, 0, 1.0))}),
              {smallOrLarge(0.01, 0.4)}, {});
  const auto standing = [](int, Stamp) { return ObjectPose(at(0, 0, 0)); };
  std::size_t scene = 0;
  for (const std::size_t variant : {1U, 0U, 1U}) {
    world.setVariants({variant});
    world.advanceTo(milliseconds(100 * scene++), standing);
  }
  world.advanceTo(seconds(1), standing);
  EXPECT_GT(world.linkPoses()[0].translation().z(), 0.25) << "it fell on the large one";
}

/// A ball lies on an object until the object is nowhere any more.
TEST(WorldObjects, ThatAreNowherePushNothingAndAreInNothingsWay) {
  World world(descriptionOf({modelOf("ball", SphereShape{0.1}, at(0, 0, 1.0))}),
              {smallOrLarge(0.2, 1.0)}, {});
  world.setVariants({1});
  const auto leaving = [](int, Stamp time) -> std::optional<ObjectPose> {
    if (time > seconds(4)) return std::nullopt;
    return ObjectPose(at(0, 0, 0.4));
  };
  world.advanceTo(seconds(0), leaving);
  world.advanceTo(seconds(4), leaving);
  EXPECT_NEAR(world.linkPoses()[0].translation().z(), 1.0, 0.01);
  EXPECT_EQ(world.obstacleNear({0, 0, 0.4}, 0.1), "one");
  world.advanceTo(seconds(5), leaving);
  EXPECT_LT(world.linkPoses()[0].translation().z(), 0.7) << "through where it was";
  EXPECT_EQ(world.obstacleNear({0, 0, 0.4}, 0.05), std::nullopt);
  EXPECT_EQ(world.obstacleAt(0, at(0, 0, 0.4), {std::nullopt}), std::nullopt);
}

/// The larger variant comes to rest higher.
TEST(WorldVariants, FallInTheActiveOne) {
  PhysicsOptions options;
  options.drops_objects = true;
  World world(descriptionOf({ground()}), {smallOrLarge(0.2, 0.8)}, options);
  for (const std::size_t variant : {1U, 0U}) {
    world.restart();
    world.setVariants({variant});
    const auto lying = world.drop({at(0, 0, 1)}, seconds(10));
    ASSERT_TRUE(lying);
    EXPECT_NEAR(lying->at(0)->translation().z(), variant == 0 ? 0.1 : 0.4, 0.01);
  }
}

}  // namespace world_variants_test
}  // namespace synthetic_dataset::world

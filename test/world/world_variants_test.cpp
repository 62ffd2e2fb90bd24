/// Objects that wear one of several models.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "world/physics/simple_models.h"
#include "world/world.h"

namespace synthetic_dataset::world {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Model cube(const std::string& name, double side) {
  return modelOf(name, BoxShape{{side, side, side}});
}

/// One a cube of 0.2 m or of 2 m, beside a cube of 0.4 m that is always the same.
std::vector<MovingObject> objects() {
  return {{cube("one", 0.2)}, {cube("one", 2.0), {}, true}, {cube("two", 0.4)}};
}

/// A metre apart: only the large one reaches the other.
ObjectPose apart(int moving_object, Stamp /*time*/) {
  return ObjectPose(at(moving_object == 2 ? 1.0 : 0.0, 0, 2));
}

TEST(WorldVariants, AreLinksOfOneObject) {
  const World world(descriptionOf({}), objects(), {});
  std::vector<std::pair<int, std::size_t>> numbers;
  for (const LinkInstance& link : world.links()) numbers.emplace_back(link.object, link.variant);
  EXPECT_THAT(numbers, ElementsAre(std::pair(0, 0U), std::pair(0, 1U), std::pair(1, 0U)));
  EXPECT_THAT(world.worn(), ElementsAre(0, 0));
}

TEST(WorldVariants, AreThereWhereTheyAreWornAndTheObjectIsThere) {
  World world(descriptionOf({}), objects(), {});
  EXPECT_THAT(world.presentLinks(), ElementsAre(true, false, true));
  world.wear({1, 0});
  EXPECT_THAT(world.worn(), ElementsAre(1, 0));
  EXPECT_THAT(world.presentLinks(), ElementsAre(false, true, true));
  world.setPresent({false, true});
  EXPECT_THAT(world.presentLinks(), ElementsAre(false, false, true));
  EXPECT_THAT(world.present(), ElementsAre(false, true));
}

TEST(WorldVariants, AreInsideOfThingsOnlyWhileTheyAreWorn) {
  World world(descriptionOf({}), objects(), {});
  world.advanceTo(seconds(1), apart);
  EXPECT_THAT(world.interpenetrations(), IsEmpty());
  EXPECT_FALSE(world.obstacleAt(1, at(0, 0, 2.5), {at(0, 0, 2)}));
  EXPECT_FALSE(world.obstacleNear({0, 0, 2.5}, 0.1));
  world.wear({1, 0});
  ASSERT_THAT(world.interpenetrations(), SizeIs(1));
  EXPECT_NEAR(world.interpenetrations()[0].depth, 0.2, 1e-3);
  EXPECT_EQ(world.obstacleAt(1, at(0, 0, 2.5), {at(0, 0, 2)}), "one");
  EXPECT_EQ(world.obstacleNear({0, 0, 2.5}, 0.1), "one");
}

TEST(WorldVariants, StandWhereTheObjectIsEvenWhileTheyAreNotWorn) {
  World world(descriptionOf({}), objects(), {});
  world.advanceTo(seconds(1), apart);
  EXPECT_TRUE(world.linkPoses()[1].isApprox(at(0, 0, 2)));
}

/// A ball that lies still, while an object stands about it that only fits in its small size.
TEST(WorldVariants, PushPropsOnlyWhileTheyAreWorn) {
  const auto ballAfter = [](std::size_t variant) {
    World world(descriptionOf({ground(), modelOf("ball", SphereShape{0.1}, at(0.5, 0, 0.1))}),
                {{cube("one", 0.2)}, {cube("one", 0.9), {}, true}}, {});
    world.wear({variant});
    const auto sliding = [](int, Stamp time) {
      return ObjectPose(at(0.1 * toSeconds(time), 0, 0.5));
    };
    for (int i = 0; i <= 10; ++i) world.advanceTo(milliseconds(100 * i), sliding);
    return world.linkPoses()[1].translation().x();
  };
  EXPECT_NEAR(ballAfter(0), 0.5, 1e-3);
  EXPECT_GT(ballAfter(1), 0.6);
}

/// They lie as high as they are large.
TEST(WorldVariants, FallInWhatIsWorn) {
  PhysicsOptions options;
  options.drops_objects = true;
  World world(descriptionOf({ground()}), {{cube("one", 0.2)}, {cube("one", 0.8), {}, true}},
              options);
  for (const std::size_t variant : {1U, 0U}) {
    world.restart();
    world.wear({variant});
    const auto lying = world.drop({at(0, 0, 1)}, seconds(10));
    ASSERT_TRUE(lying);
    EXPECT_NEAR(lying->at(0).translation().z(), variant == 0 ? 0.1 : 0.4, 0.01);
  }
}

}  // namespace
}  // namespace synthetic_dataset::world

/// Objects whose links are driven one by one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"
#include "world/physics/simple_models.h"
#include "world/world.h"

namespace synthetic_dataset::world {
namespace articulated_object_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A foot, a driven arm on it, a hand on the arm: cubes of 0.2 m, a metre apart.
MovingObject robot() {
  Model model = modelOf("robot", BoxShape{{0.2, 0.2, 0.2}});
  for (std::size_t i = 1; i <= 2; ++i) {
    model.links.push_back(
        linkOf({collisionOf(BoxShape{{0.2, 0.2, 0.2}})}, at(0, 0, static_cast<double>(i))));
    model.links[i].parent = i - 1;
  }
  return {model, {1}};
}

ObjectPose held(int, Stamp) { return {at(1, 0, 0), {at(1, 0, 1)}}; }

TEST(ArticulatedObject, LinksStandWhereTheyAreDrivenAndCarryOthers) {
  World world({}, {robot()}, {});
  const Pose X_W_arm = turnedAt({1, 2, 3}, M_PI / 2, {1, 0, 0});

  world.advanceTo(Stamp(0), [&](int, Stamp) { return ObjectPose(at(5, 0, 0), {X_W_arm}); });

  EXPECT_TRUE(world.linkPoses()[0].isApprox(at(5, 0, 0)));
  EXPECT_TRUE(world.linkPoses()[1].matrix() == X_W_arm.matrix());
  // A metre above the arm, which lies on its side: along -y.
  EXPECT_TRUE(world.linkPoses()[2].translation().isApprox(Eigen::Vector3d(1, 1, 3)));
}

TEST(ArticulatedObject, IsNeverInsideItself) {
  World world({}, {robot()}, {});
  world.advanceTo(Stamp(0), [](int, Stamp) { return ObjectPose(at(0, 0, 0), {at(0.05, 0, 0)}); });
  EXPECT_TRUE(world.interpenetrations().empty());
}

TEST(ArticulatedObject, ReportsWhatADrivenLinkIsInside) {
  World world(descriptionOf({staticModelOf("wall", BoxShape{{1, 1, 1}}, at(0, 3, 0))}), {robot()},
              {});
  world.advanceTo(Stamp(0), [](int, Stamp) { return ObjectPose(at(0, 0, 0), {at(0, 2.45, 0)}); });
  ASSERT_EQ(world.interpenetrations().size(), 1U);
  EXPECT_EQ(world.interpenetrations()[0].first, "robot");
  EXPECT_NEAR(world.interpenetrations()[0].depth, 0.05, 1e-3);
}

TEST(ArticulatedObject, PushesPropsWithADrivenLink) {
  World world(descriptionOf({ground(), modelOf("box", BoxShape{{0.2, 0.2, 0.2}}, at(0.5, 0, 0.1))}),
              {robot()}, {});
  const auto motion = [](int, Stamp time) {
    return ObjectPose(at(0, 5, 0.1), {at(0.5 * toSeconds(time), 0, 0.12)});
  };
  world.advanceTo(Stamp(0), motion);
  world.advanceTo(seconds(2), motion);
  // The arm's front is at x = 1.1 now, with the box in front of it.
  EXPECT_GT(world.linkPoses()[1].translation().x(), 1.15);
}

TEST(ArticulatedObject, NeedsAPoseForEachDrivenLink) {
  World world({}, {robot()}, {});
  EXPECT_THAT(
      test::messagesOf([&] { world.advanceTo(Stamp(0), [](int, Stamp) { return at(0, 0, 0); }); }),
      testing::ElementsAre(testing::HasSubstr("1 links are driven, but 0 poses")));
}

TEST(ArticulatedObject, CannotDriveLinksThatAreNotThere) {
  const MovingObject object(robot().variants[0].model, {1, 7});
  EXPECT_THAT(test::messagesOf([&] { World world({}, {object}, {}); }),
              testing::ElementsAre(testing::HasSubstr("link 7 cannot be driven")));
  World fine({}, {robot()}, {});
  fine.advanceTo(milliseconds(1), held);
}

}  // namespace articulated_object_test
}  // namespace synthetic_dataset::world

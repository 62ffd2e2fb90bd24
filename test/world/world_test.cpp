#include "world/world.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synthetic_dataset/errors.h"
#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace world_test {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr Stamp kStart = seconds(1'600'000'000) + nanoseconds(123'456'789);

/// A path without round numbers, which also turns about no coordinate axis.
Pose wander(int object, Stamp time) {
  const double t = toSeconds(time - kStart) + 0.37 * object;
  return turnedAt({std::sin(t), 0.3 * t - 1, 0.25 + 0.2 * std::sin(2 * t)}, 0.7 * t, {1, 2, 3});
}

const BoxShape kCube{{0.5, 0.5, 0.5}};

/// Props of every kind in a heap, which two objects stir.
Description heap() {
  std::vector<Model> models = {
      ground(), staticModelOf("step", MeshShape{weldedBoxMesh({4, 0.5, 0.2})}, at(0, 1, 0.1))};
  const std::vector<Shape> shapes = {BoxShape{{0.3, 0.2, 0.1}}, SphereShape{0.1},
                                     CylinderShape{0.08, 0.3},
                                     MeshShape{weldedBoxMesh({0.2, 0.1, 0.3})}};
  for (int i = 0; i < 12; ++i) {
    models.push_back(modelOf(
        "prop" + std::to_string(i), shapes[static_cast<std::size_t>(i) % 4],
        turnedAt({0.1 * (i % 3), 0.12 * (i % 2), 0.2 + 0.25 * i}, 0.3 * i, {1, 0.5 * i, 0.2})));
  }
  return descriptionOf(std::move(models));
}

std::vector<MovingObject> stirrers() {
  return {modelOf("a", kCube), modelOf("b", SphereShape{0.3})};
}

std::vector<Pose> posesAfter(World& world, const std::vector<Duration>& times) {
  world.advanceTo(kStart, wander);
  for (const Duration time : times) world.advanceTo(kStart + time, wander);
  return world.linkPoses();
}

void expectSameBits(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].matrix() == b[i].matrix()) << "link " << i;
  }
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

TEST(World, ListsTheDescriptionsLinksThenTheObjects) {
  Model arm = modelOf("arm", kCube);
  arm.links.push_back(linkOf({}));
  World world(descriptionOf({modelOf("prop", kCube), staticModelOf("wall", kCube)}),
              {modelOf("a", kCube), arm}, {});

  std::vector<Role> roles;
  std::vector<int> objects;
  for (const LinkInstance& link : world.links()) {
    roles.push_back(link.role);
    objects.push_back(link.object);
  }

  EXPECT_THAT(roles,
              ElementsAre(Role::kProp, Role::kStatic, Role::kObject, Role::kObject, Role::kObject));
  EXPECT_THAT(objects, ElementsAre(-1, -1, 0, 1, 1));
  EXPECT_EQ(world.links()[1].link, &world.description().models[1].links[0]);
}

TEST(World, PropsStartWhereTheirFilePutsThem) {
  Model chair = modelOf("chair", kCube, turnedAt({1, 2, 3}, 0.4, {1, 1, 0}));
  chair.links.push_back(linkOf({}, turnedAt({0, 0, 1}, 0.2, {0, 1, 0})));
  World world(descriptionOf({chair}), {}, {});

  world.advanceTo(kStart, wander);

  expectSameBits(world.linkPoses(),
                 {chair.X_WM * chair.links[0].X_ML, chair.X_WM * chair.links[1].X_ML});
  EXPECT_EQ(world.propRevision(), 0);
}

TEST(World, StaticModelsStand) {
  World world(heap(), stirrers(), {});

  const std::vector<Pose> poses = posesAfter(world, {seconds(2)});

  EXPECT_TRUE(poses[1].matrix() == at(0, 1, 0.1).matrix());
}

TEST(World, ObjectsAreExactlyWhereTheMotionSays) {
  Model arm = modelOf("arm", kCube);
  arm.links.push_back(linkOf({collisionOf(kCube)}, turnedAt({1, 2, 3}, 0.5, {0, 0, 1})));
  World world(descriptionOf({ground()}), {modelOf("a", kCube), arm}, {});
  world.advanceTo(kStart, wander);

  for (const Duration time : {nanoseconds(1), nanoseconds(33'333'333), nanoseconds(400'000'007)}) {
    world.advanceTo(kStart + time, wander);

    const Pose X_W_arm = wander(1, kStart + time);
    expectSameBits(world.linkPoses(), {Pose::Identity(), wander(0, kStart + time),
                                       X_W_arm * Pose::Identity(), X_W_arm * arm.links[1].X_ML});
  }
}

TEST(World, SameCallsGiveTheSameBits) {
  World one(heap(), stirrers(), {});
  World two(heap(), stirrers(), {});

  expectSameBits(posesAfter(one, {seconds(3)}), posesAfter(two, {seconds(3)}));
}

TEST(World, SameTimeReachedInOtherStridesGivesTheSameBits) {
  World whole(heap(), stirrers(), {});
  World cut(heap(), stirrers(), {});
  std::vector<Duration> strides;
  for (int i = 1; i <= 91; ++i) strides.emplace_back(i * nanoseconds(33'333'333));

  const std::vector<Pose> poses = posesAfter(whole, {strides.back()});

  expectSameBits(poses, posesAfter(cut, strides));
}

TEST(World, IsShownAsAnotherOneStood) {
  World moved(heap(), stirrers(), {});
  const std::vector<Pose> poses = posesAfter(moved, {milliseconds(400), milliseconds(900)});
  World shown(heap(), stirrers(), {});
  const Stamp time = kStart + milliseconds(900);
  shown.showAt(time, moved.propPoses(), {wander(0, time), wander(1, time)});
  expectSameBits(shown.linkPoses(), poses);
  EXPECT_EQ(shown.interpenetrations().size(), moved.interpenetrations().size());
  EXPECT_THAT(messageOf([&] {
                shown.showAt(time, {}, {wander(0, time), wander(1, time)});
              }),
              HasSubstr("12 props are to be shown, but 0 poses given"));
}

TEST(World, LookingForOverlapsChangesNothing) {
  World quiet(heap(), stirrers(), {});
  World asked(heap(), stirrers(), {});

  asked.advanceTo(kStart, wander);
  for (int i = 1; i <= 20; ++i) {
    asked.advanceTo(kStart + i * milliseconds(100), wander);
    (void)asked.interpenetrations();
  }

  expectSameBits(posesAfter(quiet, {seconds(2)}), asked.linkPoses());
}

TEST(World, PropsMoveSteadilyBetweenSteps) {
  // 30 Hz scenes and 250 Hz steps: without care the ball would advance by 8 or 9 steps in turn.
  Description description = descriptionOf({modelOf("ball", SphereShape{0.1})});
  World world(description, {}, {});
  world.advanceTo(kStart, wander);
  for (int i = 1; i <= 60; ++i) {
    world.advanceTo(kStart + i * nanoseconds(33'333'333), wander);
    const double t = i * 0.033333333;
    const double fallen = -world.linkPoses()[0].translation().z();
    // Semi-implicit Euler falls ahead by g h t / 2; the rest of a step, at constant speed, lags by
    // g h^2 = 0.16 mm at most.
    EXPECT_NEAR(fallen, 0.5 * 9.81 * t * (t + 0.004), 2.5e-4) << i;
  }
}

TEST(World, RestingPropKeepsItsBitsAndTheRevision) {
  World world(descriptionOf({ground(), modelOf("box", kCube, at(0, 0, 0.25))}), {}, {});
  const std::vector<Pose> poses = posesAfter(world, {seconds(3)});
  const std::int64_t revision = world.propRevision();

  world.advanceTo(kStart + seconds(4), wander);
  world.advanceTo(kStart + seconds(100), wander);

  expectSameBits(world.linkPoses(), poses);
  EXPECT_EQ(world.propRevision(), revision);
}

TEST(World, MovingPropRaisesTheRevisionAtEachScene) {
  World world(descriptionOf({modelOf("box", kCube)}), {}, {});
  world.advanceTo(kStart, wander);

  for (int i = 1; i <= 5; ++i) {
    world.advanceTo(kStart + i * milliseconds(40), wander);
    EXPECT_EQ(world.propRevision(), i);
  }
}

TEST(World, RevisionIsThePropsAlone) {
  World world(descriptionOf({ground()}), stirrers(), {});

  posesAfter(world, {seconds(1), seconds(2)});

  EXPECT_EQ(world.propRevision(), 0);
}

TEST(World, SameTimeAgainChangesNothing) {
  World world(heap(), stirrers(), {});
  const std::vector<Pose> poses = posesAfter(world, {seconds(1)});
  const std::int64_t revision = world.propRevision();

  world.advanceTo(kStart + seconds(1), wander);

  expectSameBits(world.linkPoses(), poses);
  EXPECT_EQ(world.propRevision(), revision);
}

TEST(World, AsksForMotionAtEveryStepAndNoOther) {
  std::vector<Duration> asked;
  const auto motion = [&](int, Stamp time) {
    asked.push_back(time - kStart);
    return at(9, 9, 9);
  };
  World world(descriptionOf({modelOf("prop", kCube)}), {modelOf("a", kCube)}, {});

  world.advanceTo(kStart, motion);
  world.advanceTo(kStart + milliseconds(10), motion);

  EXPECT_THAT(asked,
              ElementsAre(milliseconds(0), milliseconds(4), milliseconds(8), milliseconds(10)));
}

TEST(World, GoingBackInTimeIsAnErrorWherePhysicsMovesSomething) {
  World world(heap(), {}, {});
  world.advanceTo(nanoseconds(2000), wander);

  EXPECT_THAT(messageOf([&] { world.advanceTo(nanoseconds(1999), wander); }),
              HasSubstr("cannot go back in time, to 1999 ns from 2000 ns"));
}

TEST(World, WithoutPropsGoesBackInTime) {
  World world(descriptionOf({ground()}), stirrers(), {});
  const std::vector<Pose> then = posesAfter(world, {milliseconds(20)});
  world.advanceTo(kStart + milliseconds(50), wander);
  world.advanceTo(kStart + milliseconds(20), wander);
  expectSameBits(world.linkPoses(), then);
}

TEST(World, ObjectPoseThatIsNotFiniteIsAnError) {
  World world(descriptionOf({ground()}), {modelOf("robot", kCube)}, {});

  EXPECT_THAT(messageOf([&] {
                world.advanceTo(kStart, [](int, Stamp) { return at(std::nan(""), 0, 0); });
              }),
              HasSubstr("object 'robot': its pose at 1600000000123456789 ns is not finite"));
}

TEST(World, NamesEveryShapeAndMassThatCannotBe) {
  Model cursed = modelOf("cursed", kCube);
  cursed.links[0].inertia = Inertia{1.0, {0, 0, 0}, Eigen::Matrix3d::Zero()};

  const std::string message = messageOf([&] {
    World world(descriptionOf({staticModelOf("wall", BoxShape{{1, 0, 1}}), cursed}),
                {modelOf("robot", SphereShape{-0.5})}, {});
  });

  EXPECT_THAT(message, HasSubstr("model 'wall': collision 'collision': a side of the box is "
                                 "0.000000 m; it has to be above 0"));
  EXPECT_THAT(message, HasSubstr("model 'robot': collision 'collision': the sphere's radius"));
  EXPECT_THAT(message, HasSubstr("model 'cursed': its links' masses and moments of inertia"));
}

TEST(World, StepThatIsTooShortIsAnError) {
  EXPECT_THAT(messageOf([] {
                World world({}, {}, {nanoseconds(0), 0.01});
              }),
              HasSubstr("the simulation's step is 0 ns; it has to be at least 1000 ns"));
}

TEST(World, NegativeToleranceIsAnError) {
  EXPECT_THAT(messageOf([] {
                World world({}, {}, {milliseconds(4), -0.5});
              }),
              HasSubstr("contact tolerance is -0.5"));
}

TEST(World, PropWithoutCollisionsStaysAndIsNoted) {
  Model ghost;
  ghost.name = "ghost";
  ghost.X_WM = at(0, 0, 5);
  ghost.links = {linkOf({})};
  World world(descriptionOf({ghost}), {}, {});

  const std::vector<Pose> poses = posesAfter(world, {seconds(2)});

  EXPECT_TRUE(poses[0].matrix() == at(0, 0, 5).matrix());
  EXPECT_EQ(world.links()[0].role, Role::kStatic);
  EXPECT_THAT(world.description().notes, ElementsAre(HasSubstr("model 'ghost': it is not static")));
}

TEST(World, PropWithAnEmptyMeshStays) {
  World world(descriptionOf({modelOf("husk", MeshShape{std::make_shared<Mesh>()}, at(0, 0, 5))}),
              {modelOf("robot", MeshShape{nullptr})}, {});

  EXPECT_TRUE(posesAfter(world, {seconds(2)})[0].matrix() == at(0, 0, 5).matrix());
}

TEST(World, PlaneOnAThingThatMovesIsNoted) {
  Model robot = modelOf("robot", kCube);
  robot.links[0].collisions.push_back(collisionOf(PlaneShape{{0, 0, 1}}));

  World world(descriptionOf({}), {robot}, {});

  EXPECT_THAT(world.description().notes,
              ElementsAre(HasSubstr("model 'robot': collision 'collision': an infinite plane")));
}

TEST(World, ObjectWithoutCollisionsFollowsItsMotion) {
  Model ghost;
  ghost.name = "ghost";
  ghost.links = {linkOf({})};
  World world(descriptionOf({modelOf("prop", kCube)}), {ghost}, {});

  const std::vector<Pose> poses = posesAfter(world, {milliseconds(50)});

  EXPECT_TRUE(poses[1].matrix() == wander(0, kStart + milliseconds(50)).matrix());
  EXPECT_THAT(world.interpenetrations(), testing::IsEmpty());
}

}  // namespace world_test
}  // namespace synthetic_dataset::world

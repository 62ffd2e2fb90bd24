#include "world/physics/physics.h"

#include <limits>

#include <gmock/gmock.h>

#include <LinearMath/btScalar.h>

#include "synthetic_dataset/errors.h"
#include "world/physics/simple_models.h"
#include "world/world.h"

/// How props move, seen through World.

namespace synthetic_dataset::world {
namespace physics_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

const World::ObjectPoseAt kNoObjects = [](int, Stamp) { return Pose::Identity(); };

/// The pose of the link `index` after a time.
Pose poseAfter(World& world, std::size_t index, Stamp time,
               const World::ObjectPoseAt& motion = kNoObjects) {
  world.advanceTo(Stamp(0), motion);
  world.advanceTo(time, motion);
  return world.linkPoses()[index];
}

double angleOf(const Pose& X) { return Eigen::AngleAxisd(X.linear()).angle(); }

Model withSurface(Model model, double friction, double restitution) {
  model.links[0].collisions[0].friction = friction;
  model.links[0].collisions[0].restitution = restitution;
  return model;
}

TEST(Physics, PropFallsFreely) {
  World world(descriptionOf({modelOf("stone", SphereShape{0.1}, at(1, 2, 100))}), {}, {});

  const Pose X_WL = poseAfter(world, 0, seconds(2));

  // Semi-implicit Euler: n steps of h fall g h^2 n (n + 1) / 2.
  const double h = 0.004;
  const double n = 500;
  EXPECT_NEAR(X_WL.translation().z(), 100 - 9.81 * h * h * n * (n + 1) / 2, 2e-3);
  EXPECT_NEAR(X_WL.translation().z(), 100 - 9.81 * 2 * 2 / 2, 0.05);
  EXPECT_NEAR(X_WL.translation().x(), 1, 1e-6);
  EXPECT_NEAR(X_WL.translation().y(), 2, 1e-6);
}

TEST(Physics, GravityIsTheDescriptions) {
  Description description = descriptionOf({modelOf("stone", SphereShape{0.1})});
  description.gravity = {1.62, 0, 0};
  World world(description, {}, {});

  EXPECT_NEAR(poseAfter(world, 0, seconds(1)).translation().x(), 0.81, 0.005);
}

TEST(Physics, LinksWithoutGravityFloat) {
  Model balloon = modelOf("balloon", SphereShape{0.1}, at(0, 0, 5));
  balloon.links[0].has_gravity = false;
  Model half = modelOf("half", SphereShape{0.1}, at(3, 0, 100));
  half.links.push_back(balloon.links[0]);
  World world(descriptionOf({balloon, half}), {}, {});

  EXPECT_EQ(poseAfter(world, 0, seconds(1)).translation().z(), 5.0);
  EXPECT_NEAR(world.linkPoses()[1].translation().z(), 100 - 0.5 * 9.81 / 2, 0.02);
}

TEST(Physics, PropsThatLeaveTheWorldAreNamed) {
  World world(descriptionOf({staticModelOf("table", BoxShape{{1, 1, 1}}),
                             modelOf("cup", SphereShape{0.1}, at(0, 0, 1)),
                             modelOf("stone", SphereShape{0.1}, at(5, 0, 1))}),
              {}, {});
  world.advanceTo(Stamp(0), kNoObjects);
  EXPECT_THAT(world.fallenProps(), testing::IsEmpty());
  world.advanceTo(seconds(1), kNoObjects);
  EXPECT_THAT(world.fallenProps(), testing::IsEmpty()) << "the stone is 3.4 m below the table";
  world.advanceTo(seconds(2), kNoObjects);
  EXPECT_THAT(world.fallenProps(), testing::ElementsAre("stone"));
}

class PropAtRest : public testing::TestWithParam<std::pair<Shape, Shape>> {};

TEST_P(PropAtRest, StandsOnTheFloorAtHalfItsHeight) {
  const auto& [floor, prop] = GetParam();
  const bool plane = std::holds_alternative<PlaneShape>(floor);
  World world(descriptionOf({staticModelOf("floor", floor, at(0, 0, plane ? 0.0 : -0.5)),
                             modelOf("prop", prop, at(0.1, 0.2, 0.3))}),
              {}, {});

  const Pose X_WL = poseAfter(world, 1, seconds(5));

  EXPECT_NEAR(X_WL.translation().z(), 0.2, 1e-3);
  EXPECT_NEAR(X_WL.translation().x(), 0.1, 2e-3);
  EXPECT_NEAR(X_WL.translation().y(), 0.2, 2e-3);
  EXPECT_GT(X_WL.linear()(2, 2), std::cos(3e-3)) << "upright";
  world.advanceTo(seconds(10), kNoObjects);
  EXPECT_TRUE(X_WL.matrix() == world.linkPoses()[1].matrix()) << "asleep";
}

const Shape kFloors[] = {PlaneShape{{0, 0, 1}}, BoxShape{{10, 10, 1}},
                         MeshShape{weldedBoxMesh({10, 10, 1})}};
const BoxShape kProp{{0.5, 0.3, 0.4}};

INSTANTIATE_TEST_SUITE_P(
    OfEachKind, PropAtRest,
    testing::Values(std::pair<Shape, Shape>{kFloors[0], kProp},
                    std::pair<Shape, Shape>{kFloors[1], kProp},
                    std::pair<Shape, Shape>{kFloors[2], kProp},
                    std::pair<Shape, Shape>{kFloors[0], CylinderShape{0.1, 0.4}},
                    std::pair<Shape, Shape>{kFloors[1], CylinderShape{0.1, 0.4}},
                    std::pair<Shape, Shape>{kFloors[2], CylinderShape{0.1, 0.4}},
                    std::pair<Shape, Shape>{kFloors[0], SphereShape{0.2}},
                    std::pair<Shape, Shape>{kFloors[0], MeshShape{weldedBoxMesh(kProp.size)}},
                    std::pair<Shape, Shape>{kFloors[1], MeshShape{weldedBoxMesh(kProp.size)}},
                    std::pair<Shape, Shape>{kFloors[2], MeshShape{weldedBoxMesh(kProp.size)}}));

TEST(Physics, PropOnATiltedSlabKeepsItsTilt) {
  // 20 degrees is less than friction 1 holds (45).
  const double tilt = 20.0 * M_PI / 180.0;
  const Pose slab = turnedAt({0, 0, 0}, tilt, {0, 1, 0});
  World world(descriptionOf({staticModelOf("slab", BoxShape{{4, 4, 0.2}}, slab),
                             modelOf("box", BoxShape{{0.2, 0.2, 0.2}}, slab * at(0, 0, 0.2))}),
              {}, {});

  const Pose X_slab_box = slab.inverse() * poseAfter(world, 1, seconds(5));

  EXPECT_LT((X_slab_box.translation() - Eigen::Vector3d(0, 0, 0.2)).norm(), 2e-3);
  EXPECT_LT(angleOf(X_slab_box), 2e-3);
}

TEST(Physics, SmallerFrictionOfTheTwoDecidesWhetherAPropSlides) {
  // tan(20 degrees) = 0.364; product or mean of the two coefficients would hold the second box.
  const Pose slab = turnedAt({0, 0, 0}, 20.0 * M_PI / 180.0, {0, 1, 0});
  const auto slide = [&](double friction) {
    World world(
        descriptionOf({withSurface(staticModelOf("slab", BoxShape{{40, 4, 0.2}}, slab), 5.0, 0),
                       withSurface(modelOf("box", BoxShape{{0.4, 0.4, 0.2}}, slab * at(0, 0, 0.2)),
                                   friction, 0)}),
        {}, {});
    return Eigen::Vector3d((slab.inverse() * poseAfter(world, 1, seconds(1))).translation()).x();
  };

  EXPECT_NEAR(slide(0.40), 0.0, 2e-3);
  const double acceleration = 9.81 * (std::sin(slab.linear().eulerAngles(0, 1, 2).y()) -
                                      0.30 * std::cos(slab.linear().eulerAngles(0, 1, 2).y()));
  EXPECT_NEAR(slide(0.30), 0.5 * acceleration, 0.02);
}

TEST(Physics, BallBouncesByItsRestitution) {
  World world(
      descriptionOf({withSurface(ground(), 1.0, 1.0),
                     withSurface(modelOf("ball", SphereShape{0.1}, at(0, 0, 1.1)), 1, 0.5)}),
      {}, {});
  world.advanceTo(Stamp(0), kNoObjects);
  double highest = 0.0;
  bool has_bounced = false;
  double last = 1.1;
  for (Stamp time(0); time < milliseconds(900); time += milliseconds(4)) {
    world.advanceTo(time, kNoObjects);
    const double z = world.linkPoses()[1].translation().z();
    has_bounced = has_bounced || z > last;
    if (has_bounced) highest = std::max(highest, z - 0.1);
    last = z;
  }

  EXPECT_NEAR(highest, 0.25, 0.02);  // half the speed, a quarter of the height
}

TEST(Physics, StackOfBoxesStands) {
  std::vector<Model> models = {ground()};
  for (int i = 0; i < 5; ++i) {
    models.push_back(
        modelOf("box" + std::to_string(i), BoxShape{{0.2, 0.2, 0.2}}, at(0, 0, 0.1 + 0.2 * i)));
  }
  World world(descriptionOf(models), {}, {});

  const Pose top = poseAfter(world, 5, seconds(20));

  EXPECT_LT((top.translation() - Eigen::Vector3d(0, 0, 0.9)).norm(), 3e-3);
}

TEST(Physics, ObjectPushesAPropAlong) {
  const auto motion = [](int, Stamp time) { return at(0.5 * toSeconds(time) - 1.0, 0, 0.25); };
  World world(descriptionOf({ground(), modelOf("crate", BoxShape{{0.4, 0.4, 0.4}}, at(0, 0, 0.2))}),
              {modelOf("robot", BoxShape{{0.5, 0.5, 0.5}})}, {});

  const Pose crate = poseAfter(world, 1, seconds(4), motion);

  // The robot's front is at 1.25 m; the crate stands right in front of it.
  EXPECT_NEAR(crate.translation().x(), 1.25 + 0.2, 3e-3);
  EXPECT_NEAR(crate.translation().y(), 0.0, 1e-2);
  EXPECT_NEAR(crate.translation().z(), 0.2, 2e-3);
}

TEST(Physics, SlowObjectPushesASleepingProp) {
  const auto motion = [](int, Stamp time) {
    return at(-0.55 + 0.005 * std::max(0.0, toSeconds(time) - 10.0), 0, 0.25);
  };
  World world(descriptionOf({ground(), modelOf("crate", BoxShape{{0.4, 0.4, 0.4}}, at(0, 0, 0.2))}),
              {modelOf("robot", BoxShape{{0.5, 0.5, 0.5}})}, {});

  const Pose crate = poseAfter(world, 1, seconds(50), motion);

  EXPECT_NEAR(crate.translation().x(), -0.55 + 0.2 + 0.25 + 0.2, 2e-3);
}

TEST(Physics, RollingBallComesToRest) {
  const auto motion = [](int, Stamp time) {
    return at(std::min(toSeconds(time), 2.0), 0, 0.25);  // 1 m/s for 2 s, then it stops
  };
  World world(descriptionOf({ground(), modelOf("ball", SphereShape{0.1}, at(0.5, 0, 0.1))}),
              {modelOf("kicker", BoxShape{{0.5, 0.5, 0.5}})}, {});

  const Pose ball = poseAfter(world, 1, seconds(60), motion);
  world.advanceTo(seconds(70), motion);

  EXPECT_GT(ball.translation().x(), 5.0);
  EXPECT_NEAR(ball.translation().z(), 0.1, 1e-3);
  EXPECT_TRUE(ball.matrix() == world.linkPoses()[1].matrix());
}

TEST(Physics, PropRidesOnAnObject) {
  // Up to speed within a second, so that friction can hold the box: a = 1 m/s^2.
  const auto motion = [](int, Stamp time) {
    const double t = toSeconds(time);
    return at(t < 1 ? 0.5 * t * t : t - 0.5, 0, 0.1);
  };
  World world(descriptionOf({modelOf("box", BoxShape{{0.2, 0.2, 0.2}}, at(0, 0, 0.3))}),
              {modelOf("cart", BoxShape{{1, 1, 0.2}})}, {});

  const Pose box = poseAfter(world, 0, seconds(5), motion);

  EXPECT_NEAR(box.translation().x(), 4.5, 5e-3);
  EXPECT_NEAR(box.translation().z(), 0.3, 1e-3);
}

TEST(Physics, PropFallsWhenTheObjectBelowLeaves) {
  const auto motion = [](int, Stamp time) {
    return time < seconds(10) ? at(0, 0, 0.1) : at(0, 0, 0.1 - 5.0 * (toSeconds(time) - 10.0));
  };
  World world(descriptionOf({modelOf("box", BoxShape{{0.2, 0.2, 0.2}}, at(0, 0, 0.3))}),
              {modelOf("table", BoxShape{{1, 1, 0.2}})}, {});

  EXPECT_LT(poseAfter(world, 0, milliseconds(10400), motion).translation().z(), -0.3);
}

TEST(Physics, JumpOfAnObjectDoesNotShootPropsAway) {
  const auto motion = [](int, Stamp time) {
    return time < seconds(3) ? at(0, 0, 0.1) : at(50, 0, 0.1);
  };
  World world(descriptionOf({ground(), modelOf("box", BoxShape{{0.2, 0.2, 0.2}}, at(0, 0, 0.3))}),
              {modelOf("table", BoxShape{{1, 1, 0.2}})}, {});

  const Pose box = poseAfter(world, 1, seconds(6), motion);

  EXPECT_LT((box.translation() - Eigen::Vector3d(0, 0, 0.1)).norm(), 2e-2);
}

TEST(Physics, TurnOfAnObjectCarriesPropsRound) {
  // A turntable at 0.5 rad/s for pi seconds; the box near its rim ends up a quarter turn further.
  const auto motion = [](int, Stamp time) {
    return turnedAt({0, 0, 0.1}, 0.5 * std::min(toSeconds(time), M_PI), {0, 0, 1});
  };
  World world(descriptionOf({modelOf("box", BoxShape{{0.2, 0.2, 0.2}}, at(0.7, 0, 0.3))}),
              {modelOf("table", CylinderShape{1.0, 0.2})}, {});

  const Pose box = poseAfter(world, 0, seconds(5), motion);

  EXPECT_LT((box.translation() - Eigen::Vector3d(0, 0.7, 0.3)).norm(), 0.02);
  EXPECT_NEAR(angleOf(box), M_PI / 2, 0.02);
}

class FastProp : public testing::TestWithParam<Shape> {};

TEST_P(FastProp, DoesNotPassThroughAThinFloor) {
  // After 20 m the prop falls 8 cm in each step, four times its own size and the floor's.
  World world(descriptionOf({staticModelOf("tray", BoxShape{{2, 2, 0.01}}, at(0, 0, -0.005)),
                             modelOf("nut", GetParam(), at(0, 0, 20))}),
              {}, {});

  EXPECT_NEAR(poseAfter(world, 1, seconds(6)).translation().z(), 0.01, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, FastProp,
                         testing::Values(Shape{SphereShape{0.01}},
                                         Shape{BoxShape{{0.02, 0.02, 0.02}}},
                                         Shape{MeshShape{weldedBoxMesh({0.02, 0.02, 0.02})}}));

TEST(Physics, LinksOfAPropHoldTogether) {
  // A barbell that stands on one end falls over, and its links keep their places.
  Model barbell;
  barbell.name = "barbell";
  barbell.X_WM = turnedAt({0, 0, 0.1}, 0.02, {0, 1, 0});
  barbell.links = {linkOf({collisionOf(SphereShape{0.1})}),
                   linkOf({collisionOf(SphereShape{0.1})}, turnedAt({0, 0, 1}, 0.5, {1, 0, 0}))};
  World world(descriptionOf({ground(), barbell}), {}, {});
  world.advanceTo(Stamp(0), kNoObjects);

  world.advanceTo(seconds(8), kNoObjects);

  const Pose& lower = world.linkPoses()[1];
  const Pose& upper = world.linkPoses()[2];
  EXPECT_NEAR(lower.translation().z(), 0.1, 2e-3);
  EXPECT_NEAR(upper.translation().z(), 0.1, 2e-3);
  EXPECT_TRUE((lower.inverse() * upper).isApprox(barbell.links[1].X_ML, 1e-9));
}

TEST(Physics, TopHeavyPropTopples) {
  // The same box stands if its centre of mass is above its foot, and topples if it is beside it.
  const auto tilt = [](double offset) {
    Model box = modelOf("box", BoxShape{{0.2, 0.2, 0.6}}, at(0, 0, 0.3));
    box.links[0].inertia = Inertia{2.0, {offset, 0, 0.1}, 0.05 * Eigen::Matrix3d::Identity()};
    World world(descriptionOf({ground(), box}), {}, {});
    return angleOf(poseAfter(world, 1, seconds(5)));
  };

  EXPECT_LT(tilt(0.08), 0.01);
  EXPECT_GT(tilt(0.12), 1.5);
}

TEST(Physics, PropLostInTheVoidStopsAndHarmsNobody) {
  World world(descriptionOf({staticModelOf("floor", BoxShape{{1, 1, 0.1}}, at(0, 0, -0.05)),
                             modelOf("lost", SphereShape{0.1}, at(5, 0, 0)),
                             modelOf("kept", BoxShape{{0.2, 0.2, 0.2}}, at(0, 0, 0.1))}),
              {}, {});
  world.advanceTo(Stamp(0), kNoObjects);

  world.advanceTo(seconds(200), kNoObjects);
  const auto revision = world.propRevision();
  const auto poses = world.linkPoses();
  world.advanceTo(seconds(201), kNoObjects);

  EXPECT_EQ(world.propRevision(), revision);
  EXPECT_NEAR(poses[1].translation().z(), -1e4, 5);
  EXPECT_NEAR(poses[2].translation().z(), 0.1, 1e-3);
}

TEST(Physics, BreakdownNamesTheProp) {
  Model cursed = modelOf("cursed", SphereShape{0.1});
  cursed.links[0].inertia = Inertia{1e3, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  Description description = descriptionOf({cursed});
  description.gravity = {0, 0, 0.1 * std::numeric_limits<btScalar>::max()};  // its weight overflows
  World world(description, {}, {});
  world.advanceTo(Stamp(0), kNoObjects);

  try {
    world.advanceTo(seconds(1), kNoObjects);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'cursed'"), std::string::npos) << error.what();
  }
}

TEST(Physics, RestingContactIsGoodFarFromTheOrigin) {
  const double far = 5.0e6;
  World world(descriptionOf({staticModelOf("floor", BoxShape{{4, 4, 1}}, at(far, 0, -0.5)),
                             modelOf("box", BoxShape{{0.2, 0.2, 0.2}}, at(far + 0.3, 0, 0.2))}),
              {}, {});

  const Pose box = poseAfter(world, 1, seconds(5));

  EXPECT_NEAR(box.translation().z(), 0.1, 1e-3);
  EXPECT_NEAR(box.translation().x(), far + 0.3, 1e-3);
}

}  // namespace physics_test
}  // namespace synthetic_dataset::world

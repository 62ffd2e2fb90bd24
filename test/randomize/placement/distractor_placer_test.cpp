#include "randomize/placement/distractor_placer.h"

#include <cmath>
#include <memory>

#include <gmock/gmock.h>

#include "randomize/placement/solid_boxes.h"

namespace synthetic_dataset::randomize {
namespace distractor_placer_test {

using Eigen::Vector3d;
using test::floorBox;
using test::SolidBox;
using world::at;

constexpr double kTolerance = 0.01;  // [m] the world's, of contacts

class DistractorPlacerTest : public ::testing::Test {
 protected:
  DistractorPlacerTest() {
    config.count = base::Distribution::constant({6.0});
    config.volume = Volume{{-2, -2, 0.2}, {2, 2, 1.5}};
    for (int i = 0; i < 10; ++i) {
      boxes.push_back({"distractor_" + std::to_string(i + 1), {0.2 + 0.05 * i, 0.3, 0.4}});
    }
  }

  struct Placer {
    std::unique_ptr<world::World> world;
    std::unique_ptr<Surroundings> surroundings;
    std::unique_ptr<DistractorPlacer> placer;
  };

  [[nodiscard]] Placer make() const {
    Placer made;
    made.world = test::worldOf(standing, objects, {}, false, boxes);
    made.world->advanceTo(Stamp(1), [&](int object, Stamp /*time*/) {
      return world::ObjectPose(objects[static_cast<std::size_t>(object)].X_GB);
    });
    made.surroundings = std::make_unique<Surroundings>(*made.world);
    std::vector<Cuboid> cuboids;
    for (const SolidBox& box : boxes) cuboids.push_back(box.cuboid());
    made.placer =
        std::make_unique<DistractorPlacer>(config, cuboids, *made.world, *made.surroundings, 1);
    return made;
  }

  /// The distractors that are present, at their places in the world.
  [[nodiscard]] std::vector<SolidBox> shown(const world::World& world) const {
    std::vector<SolidBox> there;
    std::size_t next = 0;
    for (std::size_t i = 0; i < world.links().size(); ++i) {
      if (world.links()[i].role != world::Role::kDistractor) continue;
      if (world.presentLinks()[i]) {
        there.push_back(boxes[next]);
        there.back().X_GB = world.linkPoses()[i];
      }
      ++next;
    }
    return there;
  }

  DistractorOptions config;
  std::vector<SolidBox> standing{floorBox(), {"wall", {4, 0.4, 3}, at(0, 0, 1.5)}};
  std::vector<SolidBox> objects{{"alpha", {0.8, 0.8, 0.8}, at(1, 1, 0.4)}};
  std::vector<SolidBox> boxes;
};

TEST_F(DistractorPlacerTest, EachIsClearOfAllElse) {
  const Placer made = make();
  for (std::int64_t scene = 0; scene < 40; ++scene) {
    static_cast<void>(made.placer->place(scene));
    std::vector<SolidBox> all = shown(*made.world);
    const std::size_t count = all.size();
    all.insert(all.end(), standing.begin(), standing.end());
    all.insert(all.end(), objects.begin(), objects.end());
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        EXPECT_LT(test::depthOf(all[i], all[k]), kTolerance + 0.003)
            << scene << ": " << all[i].name << " in " << all[k].name;
      }
    }
  }
}

TEST_F(DistractorPlacerTest, FlyWithinTheVolumeTurnedAnyhow) {
  const Placer made = make();
  double least_upright = 1.0;
  for (std::int64_t scene = 0; scene < 30; ++scene) {
    static_cast<void>(made.placer->place(scene));
    for (const SolidBox& box : shown(*made.world)) {
      const Vector3d place = box.X_GB.translation();
      EXPECT_TRUE((place.array() >= config.volume->low.array()).all());
      EXPECT_TRUE((place.array() <= config.volume->high.array()).all());
      least_upright = std::min(least_upright, std::abs(box.X_GB.linear()(2, 2)));
    }
  }
  EXPECT_LT(least_upright, 0.1);
}

TEST_F(DistractorPlacerTest, StandOnWhatIsBelow) {
  config.mode = DistractorMode::kStand;
  standing.push_back({"table", {1.5, 1.5, 0.7}, at(-1.2, -1.2, 0.35)});
  const Placer made = make();
  bool on_table = false;
  for (std::int64_t scene = 0; scene < 40; ++scene) {
    static_cast<void>(made.placer->place(scene));
    for (const SolidBox& box : shown(*made.world)) {
      const double bottom = box.X_GB.translation().z() - 0.5 * box.size.z();
      EXPECT_TRUE(std::abs(bottom) < 1e-5 || std::abs(bottom - 0.7) < 1e-5) << bottom;
      EXPECT_NEAR(box.X_GB.linear()(2, 2), 1.0, 1e-6);
      on_table = on_table || bottom > 0.5;
    }
  }
  EXPECT_TRUE(on_table);
}

TEST_F(DistractorPlacerTest, WhatIsDroppedLiesOnSomething) {
  config.mode = DistractorMode::kDrop;
  config.volume = Volume{{-1.5, -1.5, 1.2}, {1.5, 1.5, 2.5}};
  standing.push_back({"table", {1.5, 1.5, 0.7}, at(-1.2, -1.2, 0.35)});
  const Placer made = make();
  int count = 0;
  int on_others = 0;
  for (std::int64_t scene = 0; scene < 12; ++scene) {
    const std::vector<int> numbers = made.placer->place(scene);
    const std::vector<SolidBox> there = shown(*made.world);
    std::vector<std::optional<Pose>> poses(boxes.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      poses[static_cast<std::size_t>(numbers[i] - 1)] = there[i].X_GB;
    }
    // They stay where they lie.
    const auto later = made.world->dropDistractors(poses, std::chrono::seconds(5));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!poses[i]) continue;
      ++count;
      ASSERT_TRUE(later[i]) << scene << ": " << boxes[i].name;
      EXPECT_LT((later[i]->translation() - poses[i]->translation()).norm(), 0.01);
      // A little deeper, they would be inside what carries them.
      Pose X_GB = *poses[i];
      X_GB.translation().z() -= 2.5 * kTolerance;
      std::vector<std::optional<Pose>> others = poses;
      others[i].reset();
      const auto below = made.world->obstacleOfDistractor(i, X_GB, others);
      EXPECT_TRUE(below) << scene << ": " << boxes[i].name;
      on_others += below && *below != "floor" ? 1 : 0;
    }
  }
  EXPECT_GT(count, 40);
  EXPECT_GT(on_others, 5);
}

TEST_F(DistractorPlacerTest, WhatFallsForEverIsLeftOut) {
  config.mode = DistractorMode::kDrop;
  config.fall_time = 3.0;
  config.volume = Volume{{20, 20, 1}, {22, 22, 2}};  // beside the floor
  standing.front().size = {10, 10, 0.2};
  standing.front().X_GB = at(0, 0, -0.1);
  const Placer made = make();
  EXPECT_THAT(made.placer->place(0), testing::IsEmpty());
  EXPECT_THAT(shown(*made.world), testing::IsEmpty());
}

TEST_F(DistractorPlacerTest, FallingMovesNothingElse) {
  config.mode = DistractorMode::kDrop;
  config.volume = Volume{{0.8, 0.8, 1.5}, {1.2, 1.2, 3.0}};  // above alpha
  const Placer made = make();
  const std::vector<Pose> before = made.world->linkPoses();
  EXPECT_THAT(made.placer->place(3), testing::Not(testing::IsEmpty()));
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (made.world->links()[i].role == world::Role::kDistractor) continue;
    EXPECT_EQ(made.world->linkPoses()[i].matrix(), before[i].matrix());
  }
}

TEST_F(DistractorPlacerTest, AsManyAreThereAsAreDrawn) {
  config.count = base::Distribution::choice({{0.0}, {3.4}, {99.0}});
  config.volume = Volume{{-9, -9, 1}, {9, 9, 4}};
  const Placer made = make();
  std::vector<int> times(11, 0);
  for (std::int64_t scene = 0; scene < 60; ++scene) {
    const std::vector<int> numbers = made.placer->place(scene);
    const std::vector<SolidBox> there = shown(*made.world);
    ASSERT_EQ(numbers.size(), there.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      EXPECT_EQ(there[i].name, "distractor_" + std::to_string(numbers[i]));
    }
    ++times.at(there.size());
  }
  EXPECT_GT(times[0], 10);
  EXPECT_GT(times[3], 10);
  EXPECT_GT(times[10], 10);  // the whole pool
  EXPECT_EQ(times[0] + times[3] + times[10], 60);
}

TEST_F(DistractorPlacerTest, ASceneAloneIsAsAmongOthers) {
  const Placer among = make();
  for (std::int64_t scene = 0; scene < 7; ++scene) static_cast<void>(among.placer->place(scene));
  const Placer alone = make();
  EXPECT_EQ(alone.placer->place(6), among.placer->place(6));
  const std::vector<SolidBox> a = shown(*alone.world);
  const std::vector<SolidBox> b = shown(*among.world);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].X_GB.matrix() == b[i].X_GB.matrix());
  }
}

TEST_F(DistractorPlacerTest, KeepAwayFromCameras) {
  const Placer made = make();
  const Vector3d camera(-1, -1, 0.8);
  double nearest = 1e9;
  double nearest_else = 1e9;
  for (std::int64_t scene = 0; scene < 60; ++scene) {
    static_cast<void>(made.placer->place(scene, {camera}));
    for (const SolidBox& box : shown(*made.world)) {
      nearest = std::min(nearest, box.distanceTo(camera));
    }
    static_cast<void>(made.placer->place(scene));
    for (const SolidBox& box : shown(*made.world)) {
      nearest_else = std::min(nearest_else, box.distanceTo(camera));
    }
  }
  EXPECT_GT(nearest, 0.3);
  EXPECT_LT(nearest_else, 0.3);
}

TEST_F(DistractorPlacerTest, WithoutAVolumeAreAroundTheObjects) {
  config.volume.reset();
  const Placer made = make();
  const Cuboid object_G{{4, 5, 0.5}, {5, 6, 1.5}};
  const double size = object_G.size().norm();
  const Vector3d low = object_G.low - 1.5 * Vector3d(size, size, 0);
  const Vector3d high = object_G.high + size * Vector3d(1.5, 1.5, 1);
  std::size_t count = 0;
  for (std::int64_t scene = 0; scene < 20; ++scene) {
    count += made.placer->place(scene, {}, {object_G}).size();
    for (const SolidBox& box : shown(*made.world)) {
      EXPECT_TRUE((box.X_GB.translation().array() >= low.array() - 0.5).all());
      EXPECT_TRUE((box.X_GB.translation().array() <= high.array() + 0.5).all());
    }
  }
  EXPECT_GT(count, 20U);
}

TEST_F(DistractorPlacerTest, WhatFindsNoPlaceIsLeftOut) {
  config.volume = Volume{{-0.3, -0.05, 1}, {0.3, 0.05, 1.2}};  // within the wall
  const Placer made = make();
  EXPECT_TRUE(made.placer->place(0).empty());
  EXPECT_TRUE(shown(*made.world).empty());
}

}  // namespace distractor_placer_test
}  // namespace synthetic_dataset::randomize

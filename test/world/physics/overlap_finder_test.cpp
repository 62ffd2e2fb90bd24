#include "world/physics/overlap_finder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace overlap_finder_test {

/// The overlaps of objects, and perhaps of static models, in a world that does not move.
std::vector<Interpenetration> overlaps(const std::vector<Model>& objects,
                                       const std::vector<Model>& statics = {},
                                       double tolerance = 0.01) {
  World world(descriptionOf(statics), {objects.begin(), objects.end()},
              {std::chrono::milliseconds(4), tolerance});
  world.advanceTo(Stamp(0),
                  [&](int i, Stamp) { return objects[static_cast<std::size_t>(i)].X_WM; });
  return world.interpenetrations();
}

const BoxShape kCube{{1, 1, 1}};

TEST(Interpenetration, OfTwoBoxesIsAsDeepAsTheyOverlap) {
  const auto found = overlaps({modelOf("a", kCube), modelOf("b", kCube, at(0.95, 0.2, 0.1))});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first, "a");
  EXPECT_EQ(found[0].second, "b");
  EXPECT_NEAR(found[0].depth, 0.05, 5e-4);
}

TEST(Interpenetration, OfTwoSpheresIsRadiiLessDistance) {
  const auto found = overlaps(
      {modelOf("a", SphereShape{0.5}), modelOf("b", SphereShape{0.25}, at(0.3, 0.4, 0.0))});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].depth, 0.25, 1e-5);
}

TEST(Interpenetration, OfATurnedBoxIsItsCornersDepth) {
  // A cube on edge reaches sqrt(2)/2 below its centre.
  const Pose on_edge = turnedAt({0, 0, std::sqrt(0.5) - 0.03}, M_PI / 4, {1, 0, 0});

  const auto found = overlaps({modelOf("cube", kCube, on_edge)}, {ground()});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].second, "ground");
  EXPECT_NEAR(found[0].depth, 0.03, 1e-4);
}

TEST(Interpenetration, OfACylinderInABoxIsMeasured) {
  const auto found = overlaps({modelOf("can", CylinderShape{0.2, 0.6}, at(0, 0, 0.27))},
                              {staticModelOf("slab", BoxShape{{4, 4, 0.2}}, at(0, 0, -0.1))});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].depth, 0.03, 5e-4);
}

TEST(Interpenetration, OfAMeshInAMeshIsMeasured) {
  const auto found =
      overlaps({modelOf("crate", MeshShape{weldedBoxMesh({1, 1, 1})}, at(0.1, 0.2, 0.46))},
               {staticModelOf("floor", MeshShape{weldedBoxMesh({8, 8, 2})}, at(0, 0, -1))});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].depth, 0.04, 1e-3);
}

TEST(Interpenetration, OfThingsThatStandOnTheFloorIsNone) {
  const std::vector<Model> statics = {
      ground(), staticModelOf("table", BoxShape{{2, 2, 0.1}}, at(5, 0, 0.95))};

  EXPECT_THAT(overlaps({modelOf("box", kCube, at(0, 0, 0.5)),
                        modelOf("mesh", MeshShape{weldedBoxMesh({1, 1, 1})}, at(2, 0, 0.5)),
                        modelOf("can", CylinderShape{0.1, 0.2}, at(5, 0, 1.1))},
                       statics),
              testing::IsEmpty());
}

TEST(Interpenetration, ShallowerThanTheToleranceIsNotReported) {
  const std::vector<Model> objects = {modelOf("a", kCube), modelOf("b", kCube, at(0.95, 0, 0))};

  EXPECT_THAT(overlaps(objects, {}, 0.06), testing::IsEmpty());
  EXPECT_THAT(overlaps(objects, {}, 0.04), testing::SizeIs(1));
}

TEST(Interpenetration, NamesEachPairOnceSortedByName) {
  Model shelf = staticModelOf("shelf", kCube, at(0, 0.9, 0));
  shelf.links.push_back(linkOf({collisionOf(kCube)}, at(0, -0.1, 0)));
  const auto found =
      overlaps({modelOf("zebra", kCube), modelOf("ape", kCube, at(0.9, 0, 0))}, {shelf});

  std::vector<std::string> pairs;
  for (const auto& pair : found) pairs.push_back(pair.first + "+" + pair.second);
  EXPECT_THAT(pairs, testing::ElementsAre("ape+shelf", "ape+zebra", "zebra+shelf"));
  EXPECT_NEAR(found[2].depth, 0.2, 1e-3) << "the deeper of the shelf's two collisions";
}

TEST(Interpenetration, WithPropsIsNone) {
  std::vector<Model> models = {modelOf("prop", kCube)};

  EXPECT_THAT(overlaps({modelOf("object", kCube)}, models), testing::IsEmpty());
}

TEST(Interpenetration, IsExactFarFromTheOrigin) {
  // UTM coordinates: single precision resolves only half a metre at this distance.
  const double far = 5.0e6;
  const auto found =
      overlaps({modelOf("a", kCube, at(far, 0, 0)), modelOf("b", kCube, at(far + 0.95, 0, 0))},
               {staticModelOf("wall", kCube, at(far, -0.98, 0))});

  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0].depth, 0.05, 5e-4);
  EXPECT_NEAR(found[1].depth, 0.02, 5e-4);
}

}  // namespace overlap_finder_test
}  // namespace synthetic_dataset::world

#include "render/shadows/held_casters.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace synthetic_dataset::render {
namespace held_casters_test {

constexpr double kTexel = 0.01;  // [m]

Pose at(double x) { return makePose({x, 0, 0}, Eigen::Quaterniond::Identity()); }

/// The places from which a ball casts its shadow if it is at `places` at successive times.
std::vector<double> heldAt(const std::vector<double>& places) {
  DrawItem item;
  item.bounds_V = Bounds(Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2));
  ShadowProjection shadow;
  shadow.texel = kTexel;
  std::vector<std::vector<Pose>> poses;
  for (const double place : places) poses.push_back({at(place)});
  std::vector<const std::vector<Pose>*> pointers;
  for (const auto& each : poses) pointers.push_back(&each);
  std::vector<double> held;
  for (const auto& each : heldForShadows({item}, pointers, {shadow}, 1.0)) {
    held.push_back(each[0][0].translation().x());
  }
  return held;
}

TEST(HeldCasters, AreInTheMiddleOfTimesWithinATexel) {
  EXPECT_EQ(heldAt({0.0, 0.004, 0.008, 0.012, 0.016, 0.020}),
            (std::vector<double>{0.004, 0.004, 0.004, 0.016, 0.016, 0.016}));
}

TEST(HeldCasters, AreWhereTheyAreIfTheyMoveByMoreThanATexel) {
  const std::vector<double> places = {0.0, 0.02, 0.04, 0.06};
  EXPECT_EQ(heldAt(places), places);
}

TEST(HeldCasters, CountTurnsByWhatIsFarthestFromTheAxis) {
  DrawItem item;
  item.bounds_V = Bounds(Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2));
  ShadowProjection shadow;
  shadow.texel = kTexel;
  const auto turned = [](double angle) {
    return std::vector<Pose>{makePose(
        {0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())))};
  };
  const std::vector<Pose> first = turned(0.0);
  const std::vector<Pose> little = turned(0.01);  // 3 mm at the corners
  const std::vector<Pose> far = turned(0.1);      // 28 mm
  const auto held = heldForShadows({item}, {&first, &little, &far}, {shadow}, 1.0);
  EXPECT_EQ(held[0][0][0].matrix(), held[1][0][0].matrix());
  EXPECT_EQ(held[2][0][0].matrix(), far[0].matrix());
}

TEST(HeldCasters, StayForLongerInCoarserMaps) {
  DrawItem item;
  item.bounds_V = Bounds(Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2));
  ShadowProjection fine;
  fine.texel = kTexel;
  ShadowProjection coarse;
  coarse.texel = 4.0 * kTexel;
  const std::vector<Pose> first = {at(0.0)};
  const std::vector<Pose> second = {at(0.015)};
  const auto held = heldForShadows({item}, {&first, &second}, {fine, coarse}, 1.0);
  EXPECT_EQ(held[1][0][0].matrix(), second[0].matrix());
  EXPECT_EQ(held[0][1][0].matrix(), held[1][1][0].matrix());
}

TEST(HeldCasters, AreNeverAWholeTexelAwayWhereTheyGoBackAndForth) {
  const std::vector<double> places = {0.0, 0.004, -0.004, 0.004, -0.004, 0.004, -0.005, 0.009};
  const std::vector<double> held = heldAt(places);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_LT(std::abs(held[i] - places[i]), kTexel);
}

/// The held poses at two times of a caster that moves by a vector.
std::vector<Pose> heldWithMove(const ShadowProjection& shadow, const Eigen::Vector3d& from,
                               const Eigen::Vector3d& move) {
  DrawItem item;
  item.bounds_V = Bounds(Eigen::Vector3d::Constant(-0.1), Eigen::Vector3d::Constant(0.1));
  const std::vector<Pose> first = {makePose(from, Eigen::Quaterniond::Identity())};
  const std::vector<Pose> second = {makePose(from + move, Eigen::Quaterniond::Identity())};
  const auto held = heldForShadows({item}, {&first, &second}, {shadow}, 1.0);
  return {held[0][0][0], held[1][0][0]};
}

bool isHeld(const ShadowProjection& shadow, const Eigen::Vector3d& from,
            const Eigen::Vector3d& move) {
  const std::vector<Pose> poses = heldWithMove(shadow, from, move);
  return poses[0].matrix() == poses[1].matrix();
}

TEST(HeldCasters, StayForLessLongAcrossAMapThatIsNarrow) {
  ShadowProjection narrow;  // 10 m by 1 m, from above
  narrow.size = 1000;
  narrow.texel = kTexel;
  narrow.shadow_from_world(0, 0) = 0.2;
  narrow.shadow_from_world(1, 1) = 2.0;
  EXPECT_TRUE(isHeld(narrow, {0, 0, 0}, {0.004, 0, 0}));
  EXPECT_FALSE(isHeld(narrow, {0, 0, 0}, {0, 0.004, 0}));
}

TEST(HeldCasters, StayForLessLongNearALight) {
  ShadowProjection spot;  // at the origin, along z, 90 degrees wide
  spot.size = 200;
  spot.texel = kTexel;
  spot.shadow_from_world.row(3) = Eigen::RowVector4d(0, 0, 1, 0);
  EXPECT_TRUE(isHeld(spot, {0, 0, 2.0}, {0.004, 0, 0}));
  EXPECT_FALSE(isHeld(spot, {0, 0, 0.3}, {0.004, 0, 0}));
}

}  // namespace held_casters_test
}  // namespace synthetic_dataset::render

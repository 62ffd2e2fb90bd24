#include "render/shadows/held_casters.h"

#include <vector>

#include <gtest/gtest.h>

namespace synthetic_dataset::render {
namespace held_casters_test {

constexpr double kTexel = 0.01;  // [m]

Pose at(double x) { return makePose({x, 0, 0}, Eigen::Quaterniond::Identity()); }

/// Where a ball casts at some times at which it is at some places.
std::vector<double> heldAt(const std::vector<double>& places) {
  Part part;
  part.bounds_V = Bounds(Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2));
  ShadowProjection shadow;
  shadow.texel = kTexel;
  std::vector<std::vector<Pose>> poses;
  for (const double place : places) poses.push_back({at(place)});
  std::vector<const std::vector<Pose>*> pointers;
  for (const auto& each : poses) pointers.push_back(&each);
  std::vector<double> held;
  for (const auto& each : heldForShadows({part}, pointers, {shadow}, 1.0)) {
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
  Part part;
  part.bounds_V = Bounds(Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2));
  ShadowProjection shadow;
  shadow.texel = kTexel;
  const auto turned = [](double angle) {
    return std::vector<Pose>{makePose(
        {0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())))};
  };
  const std::vector<Pose> first = turned(0.0);
  const std::vector<Pose> little = turned(0.01);  // 3 mm at the corners
  const std::vector<Pose> far = turned(0.1);      // 28 mm
  const auto held = heldForShadows({part}, {&first, &little, &far}, {shadow}, 1.0);
  EXPECT_EQ(held[0][0][0].matrix(), held[1][0][0].matrix());
  EXPECT_EQ(held[2][0][0].matrix(), far[0].matrix());
}

TEST(HeldCasters, StayForLongerInCoarserMaps) {
  Part part;
  part.bounds_V = Bounds(Eigen::Vector3d::Constant(-0.2), Eigen::Vector3d::Constant(0.2));
  ShadowProjection fine;
  fine.texel = kTexel;
  ShadowProjection coarse;
  coarse.texel = 4.0 * kTexel;
  const std::vector<Pose> first = {at(0.0)};
  const std::vector<Pose> second = {at(0.02)};
  const auto held = heldForShadows({part}, {&first, &second}, {fine, coarse}, 1.0);
  EXPECT_EQ(held[1][0][0].matrix(), second[0].matrix());
  EXPECT_EQ(held[1][1][0].matrix(), first[0].matrix());
}

}  // namespace held_casters_test
}  // namespace synthetic_dataset::render

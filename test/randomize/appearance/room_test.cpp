#include "randomize/appearance/room.h"

#include <string>

#include <gmock/gmock.h>

#include "world/world.h"

namespace synthetic_dataset::randomize {
namespace room_test {

using Eigen::Vector3d;

world::Description worldOf(const RoomOptions& options) {
  world::Description description;
  description.models.push_back(makeRoom(options));
  return description;
}

Eigen::AlignedBox3d boxOf(const world::Visual& visual) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : visual.surfaces.front().mesh->positions) {
    box.extend(visual.X_LV * p.cast<double>());
  }
  return box;
}

TEST(Room, HasItsInsideBetweenFloorAndWalls) {
  const world::Model room = makeRoom({{6.0, 4.0, 2.5}, 1.0});
  ASSERT_EQ(room.links.size(), 1U);
  const std::vector<world::Visual>& visuals = room.links[0].visuals;
  ASSERT_EQ(visuals.size(), 5U);
  EXPECT_NEAR(boxOf(visuals[0]).max().z(), 0.0, 1e-6) << "the floor faces up at 0";
  EXPECT_NEAR(boxOf(visuals[1]).min().x(), 3.0, 1e-6);
  EXPECT_NEAR(boxOf(visuals[2]).max().x(), -3.0, 1e-6);
  EXPECT_NEAR(boxOf(visuals[3]).min().y(), 2.0, 1e-6);
  EXPECT_NEAR(boxOf(visuals[4]).max().y(), -2.0, 1e-6);
  for (std::size_t i = 1; i < visuals.size(); ++i) {
    EXPECT_NEAR(boxOf(visuals[i]).min().z(), 0.0, 1e-6);
    EXPECT_NEAR(boxOf(visuals[i]).max().z(), 2.5, 1e-6);
  }
  EXPECT_TRUE(room.is_static);
}

TEST(Room, IsOpenGroundWithoutHeight) {
  const world::Model room = makeRoom({{100.0, 80.0, 0.0}, 2.0});
  ASSERT_EQ(room.links[0].visuals.size(), 1U);
  EXPECT_EQ(room.links[0].visuals[0].name, "floor");
  const Eigen::Vector2f& scale = room.links[0].visuals[0].surfaces.front().material.texture_scale;
  EXPECT_FLOAT_EQ(scale.x(), 40.0F) << "a box's upper face has its texture across y";
  EXPECT_FLOAT_EQ(scale.y(), 50.0F);
}

TEST(Room, IsSolid) {
  const world::World world(worldOf({{6.0, 4.0, 2.5}, 1.0}), {}, {});
  EXPECT_FALSE(world.obstacleNear({0, 0, 1}, 0.5));
  EXPECT_EQ(world.obstacleNear({0, 0, 0.2}, 0.5), std::string(kRoomName));
  EXPECT_EQ(world.obstacleNear({2.8, 0, 1}, 0.5), std::string(kRoomName));
}

}  // namespace room_test
}  // namespace synthetic_dataset::randomize

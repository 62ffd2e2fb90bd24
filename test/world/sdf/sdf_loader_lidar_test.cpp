#include <cmath>

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_lidar_test {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Description worldWith(const std::string& type, const std::string& content) {
  const TemporaryFolder folder;
  return loadText(
      folder, worldFile(modelElement("mast", "<pose>0 0 1 0 0 0</pose>" +
                                                 linkElement("<sensor name='scan' type='" + type +
                                                             "'>" + content + "</sensor>"))));
}

constexpr const char* kScan =
    "<scan><horizontal><samples>720</samples><resolution>0.5</resolution>"
    "<min_angle>-1.5</min_angle><max_angle>1.5</max_angle></horizontal>"
    "<vertical><samples>16</samples><min_angle>-0.2</min_angle><max_angle>0.3</max_angle>"
    "</vertical></scan>";
constexpr const char* kRange =
    "<range><min>0.3</min><max>25</max><resolution>0.01</resolution></range>";

TEST(SdfLidar, IsReadAsItsFileHasIt) {
  const Description world = worldWith(
      "ray", std::string("<pose>0.1 0 0 0 0 0</pose><update_rate>20</update_rate><ray>") + kScan +
                 kRange + "<noise><type>gaussian</type><stddev>0.02</stddev></noise></ray>");
  ASSERT_EQ(world.lidars.size(), 1U);
  const LidarSensor& lidar = world.lidars.front();
  EXPECT_EQ(lidar.name, "mast::body::scan");
  EXPECT_EQ(lidar.link, "body");
  EXPECT_TRUE(lidar.X_WS.translation().isApprox(Eigen::Vector3d(0.1, 0, 1)));
  EXPECT_EQ(lidar.azimuth.count, 360) << "samples times resolution";
  EXPECT_EQ(lidar.azimuth.first, -1.5);
  EXPECT_EQ(lidar.azimuth.last, 1.5);
  EXPECT_EQ(lidar.elevation.count, 16);
  EXPECT_EQ(lidar.elevation.last, 0.3);
  EXPECT_EQ(lidar.min_range, 0.3);
  EXPECT_EQ(lidar.max_range, 25.0);
  EXPECT_EQ(lidar.resolution, 0.01);
  EXPECT_EQ(lidar.noise, 0.02);
  EXPECT_EQ(lidar.update_rate, 20.0);
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(SdfLidar, MayBeCalledSoAndSeeWithoutEnd) {
  const Description world =
      worldWith("gpu_lidar", std::string("<lidar>") + kScan +
                                 "<range><min>0.1</min><max>inf</max></range></lidar>");
  ASSERT_EQ(world.lidars.size(), 1U);
  EXPECT_TRUE(std::isinf(world.lidars.front().max_range));
  EXPECT_EQ(world.lidars.front().update_rate, 0.0);
}

TEST(SdfLidar, LooksStraightAheadWithASingleRay) {
  const Description world = worldWith(
      "ray", std::string("<ray><scan><horizontal><samples>1</samples><min_angle>-1</min_angle>"
                         "<max_angle>1</max_angle></horizontal></scan>") +
                 kRange + "</ray>");
  EXPECT_EQ(world.lidars.at(0).azimuth.first, 0.0);
  EXPECT_EQ(world.lidars.at(0).elevation.count, 1);
}

TEST(SdfLidar, HasTheNoiseOfItsPluginWhereItHasNone) {
  const Description world =
      worldWith("ray", std::string("<ray>") + kScan + kRange +
                           "</ray><plugin name='p' filename='libgazebo_ros_velodyne_laser.so'>"
                           "<gaussianNoise>0.008</gaussianNoise></plugin>");
  EXPECT_EQ(world.lidars.at(0).noise, 0.008);
}

TEST(SdfLidar, IsLeftOutWithANoteWhereItsNumbersAreNone) {
  const Description world = worldWith(
      "ray", std::string("<ray>") + kScan + "<range><min>3</min><max>2</max></range></ray>");
  EXPECT_THAT(world.lidars, IsEmpty());
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("the lidar is left out")));
}

}  // namespace sdf_loader_lidar_test
}  // namespace synthetic_dataset::world

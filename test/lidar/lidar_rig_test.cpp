#include "lidar/lidar_rig.h"

#include <limits>

#include <gmock/gmock.h>

#include "lidar/scanned_hall.h"
#include "support/error_messages.h"

namespace synthetic_dataset::lidar {
namespace lidar_rig_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A scanner as in files for Gazebo: a full turn whose first and last rays coincide.
world::LidarSensor scan() {
  world::LidarSensor sensor;
  sensor.name = "mast::head::scan";
  sensor.link = "head";
  sensor.X_WS = test::poseAt(1, 2, 3);
  sensor.X_LS = test::poseAt(0, 0, 0.5);
  sensor.azimuth = {361, -3.14159, 3.14159};
  sensor.elevation = {3, -0.2, 0.2};
  sensor.min_range = 0.3;
  sensor.max_range = std::numeric_limits<double>::infinity();
  sensor.noise = 0.01;
  return sensor;
}

LidarOptions ofScan() {
  LidarOptions options;
  options.name = "top";
  options.group = "lidars/top";
  options.frame = "top/lidar_link";
  options.sensor = "mast::head::scan";
  return options;
}

LidarRig rigOf(const LidarOptions& options, const world::LidarSensor& sensor = scan()) {
  base::Diagnostics notes;
  return makeLidarRig(options, {{}, {sensor}, {}}, test::FakeFrameSource(), notes);
}

TEST(LidarRig, IsTheWorldsSensorAsItIs) {
  const LidarRig rig = rigOf(ofScan());
  EXPECT_THAT(rig.model.elevations, ElementsAre(-0.2, 0.0, 0.2));
  EXPECT_EQ(rig.model.noise, 0.01);
  EXPECT_EQ(rig.model.max_range, kFarthestSeen);
  EXPECT_EQ(rig.model.rate, 10.0) << "where the file says none";
  EXPECT_TRUE(rig.X_GS->isApprox(scan().X_WS));
}

TEST(LidarRig, SendsEachRayOfAWholeTurnOnceWhereGazeboSendsIt) {
  const FiringPlan plan(rigOf(ofScan()).model);
  ASSERT_EQ(plan.columns(), 360);
  for (const int column : {0, 1, 180, 359}) {
    const double azimuth = -3.14159 + column * 2.0 * 3.14159 / 360.0;
    EXPECT_TRUE(plan.direction(column, 1).isApprox(
        Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0), 1e-9));
  }
}

TEST(LidarRig, TakesWhatIsSetBesideItsSensor) {
  LidarOptions options = ofScan();
  options.changes.noise = 0.0;
  options.changes.max_range = 40.0;
  EXPECT_EQ(rigOf(options).model.noise, 0.0);
  EXPECT_EQ(rigOf(options).model.max_range, 40.0);
  options.changes.max_range = 0.2;
  EXPECT_THAT(test::messagesOf([&] { (void)rigOf(options); }),
              ElementsAre(StartsWith("lidars/top/min_range: found 0.3; the world's lidar "
                                     "'mast::head::scan' reaches 0.2 m")));
}

TEST(LidarRig, NamesSensorsThatThereAre) {
  LidarOptions options = ofScan();
  options.sensor = "mast::head::scam";
  EXPECT_THAT(test::messagesOf([&] { (void)rigOf(options); }),
              ElementsAre(HasSubstr("has a lidar 'mast::head::scam' (model::link::sensor); there "
                                    "are mast::head::scan")));
}

TEST(LidarRig, RefusesMoreRaysThanAPointCanNumber) {
  world::LidarSensor dense = scan();
  dense.azimuth.count = 70000;
  EXPECT_THAT(
      test::messagesOf([&] { (void)rigOf(ofScan(), dense); }),
      ElementsAre(StartsWith("lidars/top/sensor: 'mast::head::scan' has 3 rings of 69999")));
}

TEST(LidarRig, RidesOnALinkThatMoves) {
  test::ScannedHall hall(2);
  world::LidarSensor sensor = scan();
  sensor.name = "box1::body::scan";
  sensor.link = "body";
  base::Diagnostics notes;
  LidarOptions options = ofScan();
  options.sensor = sensor.name;
  const test::FakeFrameSource no_frames;
  const std::vector<LidarRig> lidars = {
      makeLidarRig(options, {{}, {sensor}, hall.world().links()}, no_frames, notes)};
  EXPECT_FALSE(lidars.front().followsFrame());
  SweepTaker taker(hall.world(), no_frames, lidars, hall.labels(),
                   render::GlassInLabels::kOfObjects, 7);
  taker.begin(test::kSweepTime);
  for (const Duration offset : taker.offsets(test::kSweepTime)) {
    hall.world().advanceTo(test::kSweepTime + offset, hall.poseAt());
    taker.look(offset);
  }
  const Cloud cloud = *taker.take(0, {})().clouds.front();
  EXPECT_TRUE(cloud.X_GS.isApprox(hall.boxPose(1, test::kSweepTime) * sensor.X_LS, 1e-9));
  int walls = 0;
  for (const CloudPoint& point : cloud.points) {
    if (point.instance != 0) continue;
    // Seen from the box's pose at the point's time, the walls and floor are where they stand.
    const Stamp time = test::kSweepTime + Duration(point.time);
    const Eigen::Vector3d p_G =
        hall.boxPose(1, time) * sensor.X_LS * point.position_S.cast<double>();
    const double off = std::min({7.9 - std::abs(p_G.x()), 5.9 - std::abs(p_G.y()), p_G.z() + 1.0});
    EXPECT_NEAR(off, 0.0, 2e-3 + 1e-2 * 5);  // five standard deviations of its noise
    ++walls;
  }
  EXPECT_GT(walls, 500);
}

}  // namespace lidar_rig_test
}  // namespace synthetic_dataset::lidar

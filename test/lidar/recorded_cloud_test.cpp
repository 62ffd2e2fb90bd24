#include "lidar/recorded_cloud.h"

#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lidar/scanned_hall.h"

namespace synthetic_dataset::lidar {
namespace recorded_cloud_test {

using motion::MeasuredCloud;
using motion::MeasuredPoint;
using std::chrono::milliseconds;
using test::kSweepTime;
using test::ScannedHall;

// The number of the east wall in ScannedHall::labels().
constexpr int kEast = 2;

enum class Scanner { kDrives, kStands };

/// Labels clouds recorded in a hall.
class HallRecording {
 public:
  explicit HallRecording(int boxes, Scanner scanner = Scanner::kStands)
      : hall(boxes), scanner_(scanner) {}

  [[nodiscard]] Pose scannerAt(Duration offset) const {
    return hall.driving(scanner_ == Scanner::kDrives ? kSweepTime + offset : kSweepTime);
  }

  [[nodiscard]] LabelledCloud label(const MeasuredCloud& measured) {
    const ScannedWorld scanned(hall.world(), render::GlassInLabels::kOfObjects);
    constexpr Duration kHalf = milliseconds(60);
    std::vector<WorldMoment> moments;
    for (Duration offset = -kHalf; offset <= kHalf; offset += std::chrono::microseconds(500)) {
      WorldMoment& moment = moments.emplace_back();
      moment.offset = offset;
      const std::vector<Pose> poses = hall.linkPoses(kSweepTime + offset);
      for (const MovingBody& body : scanned.moving()) moment.X_WL.emplace_back(poses[body.link]);
    }
    const RecordedMotion motion = {
        std::move(moments), std::vector<bool>(hall.world().links().size(), true),
        ScannerPath({-kHalf, kHalf},
                    [&](Duration offset) { return base::Placement(scannerAt(offset)); }),
        scannerAt(Duration{0})};
    return labelledCloud(scanned, measured, options, motion, hall.labels(), scanned.paint({}));
  }

  /// A point of the world, measured at a time.
  [[nodiscard]] MeasuredPoint pointAt(const Eigen::Vector3d& p_W, Duration time = {}) const {
    MeasuredPoint point;
    point.position = scannerAt(time).inverse() * p_W;
    point.time = time;
    return point;
  }

  ScannedHall hall;
  RecordedSweepOptions options;

 private:
  Scanner scanner_;
};

MeasuredCloud cloudOf(std::vector<MeasuredPoint> points) {
  MeasuredCloud cloud;
  cloud.points = std::move(points);
  cloud.rings = cloud.columns = 1;
  return cloud;
}

/// The centre of the +y or -y side of a box, whichever faces the scanner, at a time.
Eigen::Vector3d sideOf(const ScannedHall& hall, int box, const Eigen::Vector3d& p_WS,
                       Duration time) {
  const Pose X_WO = hall.boxPose(box, kSweepTime + time);
  const double side = (X_WO.inverse() * p_WS).y() > 0.0 ? 0.25 : -0.25;  // boxes are 0.5 m wide
  return X_WO * Eigen::Vector3d(0.0, side, 0.0);
}

TEST(RecordedCloud, OfAMovingScannerHasTheLabelsOfTheSweepThatItWas) {
  HallRecording recording(8, Scanner::kDrives);
  const auto frames = recording.hall.frames();
  const Cloud cast = test::cloudIn(recording.hall, test::exactModel(16, 1024), frames);
  MeasuredCloud measured;
  measured.rings = 16;
  measured.columns = 1024;
  for (const CloudPoint& point : cast.points) {
    measured.points.push_back({point.position_S.cast<double>(), Duration(point.time),
                               255.0 * static_cast<double>(point.intensity), point.ring,
                               point.column});
  }
  const LabelledCloud labelled = recording.label(measured);
  ASSERT_EQ(labelled.cloud.points.size(), cast.points.size());
  int others = 0;
  int of_boxes = 0;
  for (std::size_t i = 0; i < cast.points.size(); ++i) {
    const CloudPoint& point = labelled.cloud.points[i];
    const CloudPoint& right = cast.points[i];
    EXPECT_TRUE(point.position_at_stamp_S.isApprox(right.position_at_stamp_S, 1e-4F));
    EXPECT_EQ(point.position_S, right.position_S);
    EXPECT_EQ(point.time, right.time);
    EXPECT_EQ(point.column, right.column);
    EXPECT_EQ(point.ring, right.ring);
    EXPECT_NEAR(point.intensity, right.intensity, 1e-6F);
    of_boxes += right.instance > 0 ? 1 : 0;
    const bool is_same = point.instance == right.instance && point.part == right.part &&
                         point.class_number == right.class_number &&
                         point.world_class == right.world_class &&
                         point.normal_S.isApprox(right.normal_S, 1e-3F);
    others += is_same ? 0 : 1;
  }
  EXPECT_GT(of_boxes, 500);
  // Those are rays that pass an edge within rounding.
  EXPECT_LE(others, static_cast<int>(cast.points.size() / 2000));
  EXPECT_LE(labelled.unknown, others);
}

TEST(RecordedCloud, IsLabelledByWhereThingsAreAtEachPointsTime) {
  HallRecording recording(2);
  recording.options.tolerance = 0.01;
  const Duration later = milliseconds(40);
  MeasuredPoint point = recording.pointAt(
      sideOf(recording.hall, 0, recording.scannerAt({}).translation(), later), later);
  MeasuredPoint too_early = point;
  too_early.time = -later;  // the box gets there 80 ms later
  const LabelledCloud labelled = recording.label(cloudOf({point, too_early}));
  EXPECT_EQ(labelled.cloud.points[0].instance, 1);
  EXPECT_EQ(labelled.cloud.points[0].part, 2);
  EXPECT_EQ(labelled.cloud.points[1].instance, 0);
  EXPECT_EQ(labelled.unknown, 1);
}

TEST(RecordedCloud, IsLabelledByWhatLiesAtItsRangeAndNotBefore) {
  HallRecording recording(1);
  const Eigen::Vector3d p_WS = recording.scannerAt({}).translation();
  // Through the upper part of the box and on to the wall.
  const Eigen::Vector3d p_WB =
      recording.hall.boxPose(0, kSweepTime) * Eigen::Vector3d(0.0, 0.0, 0.2);
  const Eigen::Vector3d to_box = (p_WB - p_WS).normalized();
  const double to_wall = (7.9 - p_WS.x()) / to_box.x();
  ASSERT_LT(std::abs((p_WS + to_wall * to_box).y()), 5.9);
  const LabelledCloud labelled =
      recording.label(cloudOf({recording.pointAt(p_WS + to_wall * to_box),
                               recording.pointAt(p_WS + (to_wall - 0.09) * to_box),
                               recording.pointAt(p_WS + (to_wall + 0.09) * to_box),
                               recording.pointAt(p_WS + (to_wall - 0.5) * to_box),
                               recording.pointAt(p_WS + (to_wall + 0.5) * to_box)}));
  const std::vector<CloudPoint>& points = labelled.cloud.points;
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_EQ(points[i].world_class, kEast) << i;
  for (const std::size_t i : {3U, 4U}) {
    EXPECT_EQ(points[i].world_class, 0) << "nobody knows what is in the middle of the room";
    EXPECT_TRUE(points[i].normal_S.isZero(0.0F));
  }
  EXPECT_EQ(labelled.unknown, 2);
  EXPECT_NEAR(points[0].normal_S.norm(), 1.0F, 1e-5F);
}

TEST(RecordedCloud, TakesTheNearestOfSurfacesThatAreCloseTogether) {
  world::Description description;
  // A plate of 2 cm, 4 cm in front of a wall, both perpendicular to x.
  description.models.push_back(
      test::modelOf("plate", test::boxMesh({0.02, 2, 2}),
                    makePose({4.95, 0, 0}, Eigen::Quaterniond::Identity())));
  description.models.push_back(test::modelOf(
      "wall", test::boxMesh({0.2, 4, 4}), makePose({5.1, 0, 0}, Eigen::Quaterniond::Identity())));
  world::World world(std::move(description), {}, world::PhysicsOptions());
  const ScannedWorld scanned(world, render::GlassInLabels::kOfObjects);
  RecordedMotion motion = {
      {WorldMoment()}, {true, true}, ScannerPath({}, [](Duration) { return base::Placement(); })};
  const auto classOf = [&](double range) {
    MeasuredPoint point;
    point.position = {range, 0.1, 0.1};
    return labelledCloud(scanned, cloudOf({point}), {}, motion, {{0, 0, 1, 0}, {0, 0, 2, 0}},
                         scanned.paint({}))
        .cloud.points[0]
        .world_class;
  };
  EXPECT_EQ(classOf(4.80), 0);
  EXPECT_EQ(classOf(4.90), 1);
  EXPECT_EQ(classOf(4.96), 1) << "2 cm behind the plate's face, 4 cm before the wall";
  EXPECT_EQ(classOf(4.98), 2);
  EXPECT_EQ(classOf(5.05), 2);
}

TEST(RecordedCloud, HasIntensitiesOfTheScaleThatIsSet) {
  HallRecording recording(0);
  recording.options.full_intensity = 100.0;
  MeasuredPoint point = recording.pointAt({7.9, 0, 0.5});
  point.intensity = 25.0;
  MeasuredPoint bright = point;
  bright.intensity = 3000.0;
  const LabelledCloud labelled = recording.label(cloudOf({point, bright}));
  EXPECT_EQ(labelled.cloud.points[0].intensity, 0.25F);
  EXPECT_EQ(labelled.cloud.points[1].intensity, 1.0F);
  EXPECT_EQ(labelled.too_bright, 1);
}

TEST(RecordedCloud, MayBeEmpty) {
  HallRecording recording(0);
  EXPECT_TRUE(recording.label({}).cloud.points.empty());
}

TEST(RecordedCloud, FollowsAScannersPath) {
  const auto along = [](Duration offset) {
    return base::Placement(makePose({toSeconds(offset), 0, 0}, Eigen::Quaterniond::Identity()));
  };
  const ScannerPath path({milliseconds(-3), std::chrono::microseconds(1234)}, along);
  for (const std::int64_t microseconds : {-3000, -2999, -1, 0, 777, 1201, 1233, 1234}) {
    const Duration offset = std::chrono::microseconds(microseconds);
    EXPECT_NEAR(path.at(offset).position.x(), toSeconds(offset), 1e-12);
  }
}

}  // namespace recorded_cloud_test
}  // namespace synthetic_dataset::lidar

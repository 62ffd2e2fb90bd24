#include "motion/tf/transform_recording.h"

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/bag/ros_time.h"
#include "motion/recorded.h"

namespace synthetic_dataset::motion {
namespace transform_recording_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

geometry_msgs::TransformStamped transformAt(std::uint32_t seconds, double x,
                                            const std::string& parent = "map") {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.header.stamp = ros::Time(seconds, 0);
  transform.child_frame_id = "alpha";
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  return transform;
}

/// Adds a transform; their record times are a second apart, after 1000 s.
void add(TransformRecording& recording, const geometry_msgs::TransformStamped& transform,
         TransformKind kind) {
  static std::int64_t count = 0;
  const Stamp recorded = std::chrono::seconds(1000 + ++count);
  recording.add(
      {transform, kind, "a.bag", recorded, {recorded, 0, static_cast<MessagePlace>(count)}, ""});
}

double xAt(TransformRecording& recording, double seconds) {
  const FrameTree tree = recording.finish();
  const Stamp time = toStamp(ros::Time(seconds));
  return tree.transform(*tree.names().find("map"), *tree.names().find("alpha"), time)
      ->translation()
      .x();
}

TEST(TransformRecording, SortsTransformsThatWereRecordedLate) {
  TransformRecording recording;
  add(recording, transformAt(3, 30.0), TransformKind::kMoving);
  add(recording, transformAt(1, 10.0), TransformKind::kMoving);
  add(recording, transformAt(2, 25.0), TransformKind::kMoving);
  EXPECT_DOUBLE_EQ(xAt(recording, 1.5), 17.5);
}

TEST(TransformRecording, KeepsTheFirstOfEqualStampsAndTellsOfTheOther) {
  TransformRecording recording;
  add(recording, transformAt(1, 10.0), TransformKind::kMoving);
  add(recording, transformAt(1, 99.0), TransformKind::kMoving);
  EXPECT_DOUBLE_EQ(xAt(recording, 1.0), 10.0);
  EXPECT_THAT(recording.notes(),
              ElementsAre(AllOf(HasSubstr("1 transform of map -> alpha was left out"),
                                HasSubstr("the same time stamp (first at 1.000000000 s)"))));
}

TEST(TransformRecording, SaysNothingAboutPlainRepetitions) {
  TransformRecording recording;
  add(recording, transformAt(1, 10.0), TransformKind::kMoving);
  add(recording, transformAt(1, 10.0), TransformKind::kMoving);
  static_cast<void>(recording.finish());
  EXPECT_THAT(recording.notes(), IsEmpty());
}

TEST(TransformRecording, HoldsEachValueOfAStaticTransformUntilTheNext) {
  TransformRecording recording;
  add(recording, transformAt(100, 10.0), TransformKind::kStatic);
  add(recording, transformAt(100, 10.0), TransformKind::kStatic);
  add(recording, transformAt(200, 20.0), TransformKind::kStatic);
  const FrameTree tree = recording.finish();
  const auto xAtSeconds = [&](std::int64_t seconds) {
    return tree
        .transform(*tree.names().find("map"), *tree.names().find("alpha"),
                   std::chrono::seconds(seconds))
        ->translation()
        .x();
  };
  EXPECT_DOUBLE_EQ(xAtSeconds(1), 10.0) << "the first value holds before it, too";
  EXPECT_DOUBLE_EQ(xAtSeconds(199), 10.0);
  EXPECT_DOUBLE_EQ(xAtSeconds(200), 20.0);
  EXPECT_DOUBLE_EQ(xAtSeconds(500), 20.0);
  ASSERT_THAT(recording.findings(), ::testing::SizeIs(1));
  EXPECT_THAT(recording.findings().front().message,
              HasSubstr("the static transform 'map' -> 'alpha' changes at 200.000000000 s"));
}

TEST(TransformRecording, TakesTheRecordTimeOfAStaticTransformWithoutAStamp) {
  TransformRecording recording;
  const std::vector<std::pair<std::int64_t, double>> values{{100, 10.0}, {200, 20.0}, {300, 30.0}};
  for (const auto& [seconds, x] : values) {
    const Stamp recorded = std::chrono::seconds(seconds);
    recording.add({transformAt(0, x),
                   TransformKind::kStatic,
                   "a.bag",
                   recorded,
                   {recorded, 0, static_cast<MessagePlace>(seconds)},
                   ""});
  }
  const FrameTree tree = recording.finish();
  const auto pose = tree.transform(*tree.names().find("map"), *tree.names().find("alpha"),
                                   std::chrono::seconds(250));
  EXPECT_DOUBLE_EQ(pose->translation().x(), 20.0);
}

TEST(TransformRecording, TakesRecordTimesWhereAllStampsOfAFrameAreZero) {
  TransformRecording recording;
  for (const std::int64_t seconds : {100, 200}) {
    const Stamp recorded = std::chrono::seconds(seconds);
    recording.add({transformAt(0, 0.1 * static_cast<double>(seconds)),
                   TransformKind::kMoving,
                   "a.bag",
                   recorded,
                   {recorded, 0, static_cast<MessagePlace>(seconds)},
                   ""});
  }
  EXPECT_DOUBLE_EQ(xAt(recording, 150.0), 15.0);
  ASSERT_THAT(recording.findings(), ::testing::SizeIs(1));
  EXPECT_THAT(recording.findings().front().message, HasSubstr("have time stamps of zero"));
}

TEST(TransformRecording, OfWhatStandsStillWithoutStampsIsKnownAllTheTime) {
  // gazebo_msgs/LinkStates: at rest, then moving, then at rest again.
  TransformRecording recording;
  for (std::int64_t seconds = 100; seconds <= 120; ++seconds) {
    const Stamp recorded = std::chrono::seconds(seconds);
    const double x = seconds <= 110   ? 1.0
                     : seconds <= 112 ? 1.0 + 0.5 * static_cast<double>(seconds - 110)
                                      : 2.0;
    recording.add({transformAt(0, x),
                   TransformKind::kMoving,
                   "a.bag",
                   recorded,
                   {recorded, 0, static_cast<MessagePlace>(seconds)},
                   ""});
  }
  const FrameTree tree = recording.finish();
  const auto xAtTime = [&](double seconds) {
    return tree
        .transform(*tree.names().find("map"), *tree.names().find("alpha"),
                   toStamp(ros::Time(seconds)))
        ->translation()
        .x();
  };
  EXPECT_DOUBLE_EQ(xAtTime(100.0), 1.0);
  EXPECT_DOUBLE_EQ(xAtTime(109.5), 1.0);
  EXPECT_DOUBLE_EQ(xAtTime(110.5), 1.25);
  EXPECT_DOUBLE_EQ(xAtTime(111.5), 1.75);
  EXPECT_DOUBLE_EQ(xAtTime(120.0), 2.0);
}

TEST(TransformRecording, DoesNotMindTheStampsOfStaticTransforms) {
  TransformRecording recording;
  auto transform = transformAt(4294967295U, 10.0);
  transform.header.stamp.nsec = 4294967295U;  // as in a damaged message
  add(recording, transform, TransformKind::kStatic);
  EXPECT_DOUBLE_EQ(xAt(recording, 500.0), 10.0);
}

TEST(TransformRecording, LetsTheFirstTransformDecideWhetherAFrameIsStatic) {
  TransformRecording fixed;
  add(fixed, transformAt(1, 10.0), TransformKind::kStatic);
  add(fixed, transformAt(2, 20.0), TransformKind::kMoving);
  EXPECT_DOUBLE_EQ(xAt(fixed, 500.0), 20.0);

  TransformRecording moving;
  add(moving, transformAt(1, 10.0), TransformKind::kMoving);
  add(moving, transformAt(2, 20.0), TransformKind::kStatic);
  EXPECT_DOUBLE_EQ(xAt(moving, 1.5), 15.0);
}

TEST(TransformRecording, KeepsStampsThatAreHoursApart) {
  TransformRecording recording;
  add(recording, transformAt(1650000000, 0.0), TransformKind::kMoving);
  add(recording, transformAt(1650400000, 400.0), TransformKind::kMoving);
  EXPECT_DOUBLE_EQ(xAt(recording, 1650100000.0), 100.0);
}

TEST(TransformRecording, RefusesStampsThatNoRecordingHasTogether) {
  TransformRecording recording;
  add(recording, transformAt(1, 0.0), TransformKind::kMoving);
  add(recording, transformAt(4000000000, 0.0), TransformKind::kMoving);
  EXPECT_THAT(messageOf([&] { static_cast<void>(recording.finish()); }),
              AllOf(HasSubstr("frame 'alpha'"), HasSubstr("from 1.000000000 s"),
                    HasSubstr("to 4000000000.000000000 s"), HasSubstr("more than ROS can hold")));
}

TEST(TransformRecording, DoesNotKnowFramesOfTransformsThatWereLeftOut) {
  TransformRecording recording;
  auto transform = transformAt(1, 0.0);
  transform.transform.rotation.w = 0.0;
  add(recording, transform, TransformKind::kMoving);
  EXPECT_TRUE(recording.empty());
  EXPECT_EQ(recording.finish().names().find("alpha"), std::nullopt);
}

}  // namespace transform_recording_test
}  // namespace synthetic_dataset::motion

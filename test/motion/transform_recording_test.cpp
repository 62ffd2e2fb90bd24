#include "motion/transform_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "motion/ros_time.h"

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

double xAt(TransformRecording& recording, double seconds) {
  const FrameTree tree = recording.finish();
  const Stamp time = toStamp(ros::Time(seconds));
  return tree.transform(*tree.names().find("map"), *tree.names().find("alpha"), time)
      ->translation()
      .x();
}

TEST(TransformRecording, SortsTransformsThatWereRecordedLate) {
  TransformRecording recording;
  recording.add(transformAt(3, 30.0), TransformKind::kMoving, "a.bag");
  recording.add(transformAt(1, 10.0), TransformKind::kMoving, "a.bag");
  recording.add(transformAt(2, 25.0), TransformKind::kMoving, "a.bag");
  EXPECT_DOUBLE_EQ(xAt(recording, 1.5), 17.5);
}

TEST(TransformRecording, KeepsTheFirstOfEqualStampsAndTellsOfTheOther) {
  TransformRecording recording;
  recording.add(transformAt(1, 10.0), TransformKind::kMoving, "a.bag");
  recording.add(transformAt(1, 99.0), TransformKind::kMoving, "a.bag");
  EXPECT_DOUBLE_EQ(xAt(recording, 1.0), 10.0);
  EXPECT_THAT(recording.notes(),
              ElementsAre(AllOf(HasSubstr("1 transform of map -> alpha was left out"),
                                HasSubstr("the same time stamp (first at 1.000000000 s)"))));
}

TEST(TransformRecording, SaysNothingAboutPlainRepetitions) {
  TransformRecording recording;
  recording.add(transformAt(1, 10.0), TransformKind::kMoving, "a.bag");
  recording.add(transformAt(1, 10.0), TransformKind::kMoving, "a.bag");
  static_cast<void>(recording.finish());
  EXPECT_THAT(recording.notes(), IsEmpty());
}

TEST(TransformRecording, TakesTheLastOfStaticTransforms) {
  TransformRecording recording;
  recording.add(transformAt(1, 10.0, "odom"), TransformKind::kStatic, "a.bag");
  recording.add(transformAt(2, 20.0), TransformKind::kStatic, "a.bag");
  EXPECT_DOUBLE_EQ(xAt(recording, 500.0), 20.0);
}

TEST(TransformRecording, DoesNotMindTheStampsOfStaticTransforms) {
  TransformRecording recording;
  auto transform = transformAt(4294967295U, 10.0);
  transform.header.stamp.nsec = 4294967295U;  // as a damaged message may have it
  recording.add(transform, TransformKind::kStatic, "a.bag");
  EXPECT_DOUBLE_EQ(xAt(recording, 500.0), 10.0);
}

TEST(TransformRecording, LetsTheFirstTransformDecideWhetherAFrameIsStatic) {
  TransformRecording fixed;
  fixed.add(transformAt(1, 10.0), TransformKind::kStatic, "a.bag");
  fixed.add(transformAt(2, 20.0), TransformKind::kMoving, "a.bag");
  EXPECT_DOUBLE_EQ(xAt(fixed, 500.0), 20.0);

  TransformRecording moving;
  moving.add(transformAt(1, 10.0), TransformKind::kMoving, "a.bag");
  moving.add(transformAt(2, 20.0), TransformKind::kStatic, "a.bag");
  EXPECT_DOUBLE_EQ(xAt(moving, 1.5), 15.0);
}

TEST(TransformRecording, KeepsStampsThatAreHoursApart) {
  TransformRecording recording;
  recording.add(transformAt(1650000000, 0.0), TransformKind::kMoving, "a.bag");
  recording.add(transformAt(1650400000, 400.0), TransformKind::kMoving, "a.bag");
  EXPECT_DOUBLE_EQ(xAt(recording, 1650100000.0), 100.0);
}

TEST(TransformRecording, RefusesStampsThatNoRecordingHasTogether) {
  TransformRecording recording;
  recording.add(transformAt(1, 0.0), TransformKind::kMoving, "a.bag");
  recording.add(transformAt(4000000000, 0.0), TransformKind::kMoving, "a.bag");
  EXPECT_THAT(messageOf([&] { static_cast<void>(recording.finish()); }),
              AllOf(HasSubstr("frame 'alpha'"), HasSubstr("from 1.000000000 s"),
                    HasSubstr("to 4000000000.000000000 s"), HasSubstr("more than ROS can hold")));
}

TEST(TransformRecording, DoesNotKnowFramesOfTransformsThatWereLeftOut) {
  TransformRecording recording;
  auto transform = transformAt(1, 0.0);
  transform.transform.rotation.w = 0.0;
  recording.add(transform, TransformKind::kMoving, "a.bag");
  EXPECT_TRUE(recording.empty());
  EXPECT_EQ(recording.finish().names().find("alpha"), std::nullopt);
}

}  // namespace transform_recording_test
}  // namespace synthetic_dataset::motion

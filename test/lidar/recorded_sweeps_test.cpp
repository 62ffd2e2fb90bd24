#include "lidar/recorded_sweeps.h"

#include <gmock/gmock.h>

#include "support/bag_builder.h"
#include "support/cloud_message.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::lidar {
namespace recorded_sweeps_test {

using sensor_msgs::PointField;
using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RecordedSweepsTest : public ::testing::Test {
 protected:
  RecordedSweepsTest() {
    lidar.name = "top";
    lidar.group = "lidars/top";
    lidar.recorded.emplace();
    lidar.recorded->topic = "/points";
  }

  /// Two points, the last measured at the stamp and the first 100 ms earlier, as in the clouds of
  /// Velodyne's driver.
  static sensor_msgs::PointCloud2 sweepUntil(std::int64_t end_ms,
                                             const std::string& frame = "velodyne") {
    return test::cloudMessage(frame, milliseconds(end_ms),
                              {{"x", PointField::FLOAT32, {1, 2}},
                               {"y", PointField::FLOAT32, {0, 0}},
                               {"z", PointField::FLOAT32, {0, 0}},
                               {"time", PointField::FLOAT64, {-0.1, 0.0}}});
  }

  RecordedSweeps read() { return RecordedSweeps(lidar, {bag.close()}, notes); }

  test::TemporaryFolder folder;
  LidarOptions lidar;
  base::Diagnostics notes;
  BagBuilder bag{folder / "run.bag"};
};

TEST_F(RecordedSweepsTest, GiveASceneTheCloudWhoseMiddleIsNearest) {
  for (const int end : {1100, 1200, 1300}) bag.cloud("/points", sweepUntil(end));
  const RecordedSweeps sweeps = read();
  EXPECT_EQ(sweeps.frame(), "velodyne");
  const motion::TimeRange times = sweeps.timesAround(milliseconds(1130));
  EXPECT_EQ(times.first, milliseconds(-30)) << "the stamp of the cloud before is nearer";
  EXPECT_EQ(times.last, milliseconds(70));
  EXPECT_EQ(sweeps.distanceTo(milliseconds(1130)), milliseconds(20));
  const motion::MeasuredCloud measured = sweeps.read(milliseconds(1130));
  EXPECT_EQ(measured.points[0].time, milliseconds(-30));
  EXPECT_EQ(measured.points[1].time, milliseconds(70));
}

TEST_F(RecordedSweepsTest, GiveASceneTheCloudOfItsOwnStamp) {
  for (const int end : {1100, 1200}) bag.cloud("/points", sweepUntil(end));
  lidar.recorded->time_offset = milliseconds(-7);
  const RecordedSweeps sweeps = read();
  EXPECT_THAT(sweeps.stamps(), ElementsAre(milliseconds(1093), milliseconds(1193)));
  EXPECT_EQ(sweeps.distanceTo(milliseconds(1093)), Duration{0});
  EXPECT_EQ(sweeps.timesAround(milliseconds(1093)).first, milliseconds(-100));
  EXPECT_EQ(sweeps.timesAround(milliseconds(1093)).last, Duration{0});
  EXPECT_EQ(sweeps.timesAround(milliseconds(1000)).first, milliseconds(-7)) << "with its clock";
}

TEST_F(RecordedSweepsTest, LeaveCloudsOut) {
  for (const int end : {1100, 1200, 1300, 1300, 1400}) bag.cloud("/points", sweepUntil(end));
  lidar.recorded->every = 3;
  const RecordedSweeps sweeps = read();
  EXPECT_THAT(sweeps.stamps(), ElementsAre(milliseconds(1100), milliseconds(1400)));
  EXPECT_THAT(notes.messages(base::Severity::kWarning),
              ElementsAre("lidars/top/cloud_topic: clouds with the same stamp as another are left "
                          "out"));
}

TEST_F(RecordedSweepsTest, NameWhatCannotBeRead) {
  bag.cloud("/points", sweepUntil(1100));
  for (const int end : {1200, 1300}) {
    sensor_msgs::PointCloud2 blind = sweepUntil(end);
    blind.fields[2].name = "height";
    bag.cloud("/points", blind);
  }
  const RecordedSweeps sweeps = read();
  EXPECT_FALSE(sweeps.problem({milliseconds(1100)}));
  EXPECT_THAT(*sweeps.problem(sweeps.stamps()),
              AllOf(HasSubstr("lidars/top/cloud_topic: the cloud of '/points' at 1.200000000 s has "
                              "no field z; it has x, y, height, time"),
                    HasSubstr("; 1 more scenes have such clouds")));
  EXPECT_THAT(test::messagesOf([&] { (void)sweeps.read(milliseconds(1200)); }),
              ElementsAre(AllOf(HasSubstr("the cloud of '/points' at 1.200000000 s: "),
                                HasSubstr("has no field z"))));
}

TEST_F(RecordedSweepsTest, AreOfOneFrameAndOfTheRightType) {
  bag.cloud("/points", sweepUntil(1100))
      .cloud("/points", sweepUntil(1200, "other"))
      .say("/chatter", milliseconds(1000));
  const std::string file = bag.close();
  const auto problems = [&] {
    return test::messagesOf([&] { const RecordedSweeps sweeps(lidar, {file}, notes); });
  };
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("at 1.200000000 s is in the frame 'other', and "
                                                "those before it in 'velodyne'")));
  lidar.recorded->topic = "/chatter";
  EXPECT_THAT(problems(), ElementsAre(AllOf(HasSubstr("lidars/top/cloud_topic: "),
                                            HasSubstr("should be sensor_msgs/PointCloud2"))));
}

}  // namespace recorded_sweeps_test
}  // namespace synthetic_dataset::lidar

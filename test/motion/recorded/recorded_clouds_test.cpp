#include "motion/recorded/recorded_clouds.h"

#include <array>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>

#include "motion/ros2_bags.h"
#include "support/bag_builder.h"
#include "support/cloud_message.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace recorded_clouds_test {

using sensor_msgs::PointField;
using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RecordedCloudsTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
};

TEST_F(RecordedCloudsTest, HavePointsAFrameAndAStamp) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string file = BagBuilder(folder / "run.bag")
                               .from("/scanner")
                               .cloud("/points", milliseconds(2000), {{1, 2, 3}})
                               .cloud("/points", milliseconds(1500), {{4, 5, 6}, {nan, 0, 0}})
                               .close();
  const RecordedClouds clouds({file}, "/points");
  ASSERT_EQ(clouds.heads().size(), 2U);
  EXPECT_EQ(clouds.heads()[0].stamp, milliseconds(1500));
  EXPECT_EQ(clouds.heads()[0].frame, "scanner");
  EXPECT_EQ(clouds.heads()[0].problem, "");
  EXPECT_THAT(clouds.read(0), ElementsAre(Eigen::Vector3d(4, 5, 6))) << "what is finite";
  EXPECT_THAT(clouds.read(1), ElementsAre(Eigen::Vector3d(1, 2, 3)));
}

TEST_F(RecordedCloudsTest, AreOfATopicThatIsThere) {
  const std::string file = BagBuilder(folder / "run.bag")
                               .cloud("/points", milliseconds(1000), {{1, 2, 3}})
                               .say("/chatter", milliseconds(1000))
                               .close();
  EXPECT_THAT(test::messagesOf([&] { const RecordedClouds clouds({file}, "/point"); }),
              ElementsAre(AllOf(HasSubstr("it has /points"), HasSubstr("did you mean"))));
  EXPECT_THAT(test::messagesOf([&] { const RecordedClouds clouds({file}, "/chatter"); }),
              ElementsAre(HasSubstr("they should be sensor_msgs/PointCloud2")));
}

TEST_F(RecordedCloudsTest, KnowWhenTheirPointsWereMeasured) {
  const std::string file =
      BagBuilder(folder / "run.bag")
          .cloud("/points", test::cloudMessage("top", milliseconds(1000),
                                               {{"x", PointField::FLOAT32, {1, 2}},
                                                {"y", PointField::FLOAT32, {0, 0}},
                                                {"z", PointField::FLOAT32, {0, 0}},
                                                {"t", PointField::UINT32, {3e6, 90e6}}}))
          .cloud("/points", test::cloudMessage("top", milliseconds(1100),
                                               {{"x", PointField::FLOAT32, {1, 2}},
                                                {"y", PointField::FLOAT32, {0, 0}},
                                                {"z", PointField::FLOAT32, {0, 0}},
                                                {"time", PointField::FLOAT32, {0, 77}}}))
          .close();
  const RecordedClouds clouds({file}, "/points");
  EXPECT_EQ(clouds.heads()[0].times.first, milliseconds(3));
  EXPECT_EQ(clouds.heads()[0].times.last, milliseconds(90));
  EXPECT_EQ(clouds.readMeasured(0).points[1].time, milliseconds(90));
  EXPECT_EQ(clouds.heads()[1].problem, "") << "where they are is known";
  EXPECT_THAT(clouds.heads()[1].time_problem, HasSubstr("has points of the times 0"));
}

TEST_F(RecordedCloudsTest, AreReadFromABagOfRos2) {
  CdrText message;
  message.header(milliseconds(1500), "top");
  message.number<std::uint32_t>(1).number<std::uint32_t>(2);  // height, width
  message.number<std::uint32_t>(4);
  std::uint32_t offset = 0;
  for (const char* const name : {"x", "y", "z", "time"}) {
    message.text(name).number(offset).number<std::uint8_t>(PointField::FLOAT32);
    message.number<std::uint32_t>(1);
    offset += 4;
  }
  message.number<std::uint8_t>(0).number<std::uint32_t>(16).number<std::uint32_t>(32);
  message.number<std::uint32_t>(32);
  for (const float number : {1.0F, 2.0F, 3.0F, -0.1F, 4.0F, 5.0F, 6.0F, 0.0F}) {
    std::array<std::uint8_t, 4> bytes{};
    std::memcpy(bytes.data(), &number, bytes.size());
    for (const std::uint8_t byte : bytes) message.number(byte);
  }
  message.number<std::uint8_t>(1);  // dense
  TestBag bag;
  bag.topics = {{"/points", "sensor_msgs/msg/PointCloud2"}};
  bag.messages = {{0, milliseconds(1600), message.str()}};
  const RecordedClouds clouds({folder.write("run.mcap", mcapOf(bag)).string()}, "/points");
  ASSERT_EQ(clouds.heads().size(), 1U);
  EXPECT_EQ(clouds.heads()[0].stamp, milliseconds(1500));
  EXPECT_EQ(clouds.heads()[0].times.first, Duration(-100000001)) << "as 32 bits have it";
  const MeasuredCloud measured = clouds.readMeasured(0);
  ASSERT_EQ(measured.points.size(), 2U);
  EXPECT_EQ(measured.points[1].position, Eigen::Vector3d(4, 5, 6));
}

}  // namespace recorded_clouds_test
}  // namespace synthetic_dataset::motion

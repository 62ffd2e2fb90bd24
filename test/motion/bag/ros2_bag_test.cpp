#include "motion/bag/ros2_bag.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "motion/ros2_bags.h"
#include "motion/tf/bag_reader.h"
#include "support/bag_builder.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace ros2_bag_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Ros2BagTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }
  std::string writeDatabase(const std::string& name, const TestBag& content) {
    writeSqlite(path(name), content);
    return path(name);
  }
  /// The robot's x coordinates, in the order of record times.
  static std::vector<double> read(const std::vector<std::string>& bags) {
    std::vector<double> xs;
    readTransforms(bags, [&](const RecordedTransform& each) {
      xs.push_back(each.transform.transform.translation.x);
    });
    return xs;
  }
  static std::string errorOf(const std::string& bag) {
    return messageOf([&] { (void)read({bag}); });
  }

  test::TemporaryFolder folder;
  TestBag bag = drivingBag();
};

TEST_F(Ros2BagTest, EachKindOfFileHasTheSameTransforms) {
  const std::string database = writeDatabase("a.db3", bag);
  const std::string mcap = folder.write("a.mcap", mcapOf(bag, {2, "zstd"})).string();
  const std::string file = folder.write("b.db3.zstd", zstdFrame(test::readFile(database))).string();
  const std::string packed = folder.write("b.mcap.zstd", zstdFrame(mcapOf(bag))).string();
  TestBag by_message = bag;
  for (TestMessage& each : by_message.messages) each.bytes = zstdFrame(each.bytes);
  const std::string messages = writeDatabase("c.db3", by_message);
  for (const std::string& each : {database, mcap, file, packed, messages}) {
    EXPECT_THAT(read({each}), ElementsAre(1.0, 2.0, 3.0)) << each;
  }
  EXPECT_EQ(openBag(mcap)->kind(), "ROS 2 (mcap, zstd)");
  EXPECT_EQ(openBag(file)->kind(), "ROS 2 (sqlite3, zstd of the file)");
}

TEST_F(Ros2BagTest, AFolderIsOneRecordingOfItsFiles) {
  TestBag late = drivingBag(5);
  late.messages.erase(late.messages.begin(), late.messages.begin() + 3);
  std::filesystem::create_directory(path("day"));
  folder.write("day/day_1.mcap", mcapOf(late));
  writeDatabase("day/day_0.db3", bag);
  EXPECT_THAT(read({path("day")}), ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0));
  folder.write("day/metadata.yaml", metadataOf({"day_0.db3", "day_1.mcap"}));
  EXPECT_THAT(read({path("day")}), ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0));
  EXPECT_EQ(openBag(path("day"))->kind(), "ROS 2 (sqlite3, 2 files)");
  EXPECT_THAT(filesOfBag(path("day")), ElementsAre(path("day/day_0.db3"), path("day/day_1.mcap"),
                                                   path("day/metadata.yaml")));
}

TEST_F(Ros2BagTest, CountsAsOneRecordingWithBagsOfRos1) {
  const std::string old = test::BagBuilder(folder / "old.bag")
                              .move("map", "robot", test::milliseconds(1500), test::poseAt(9, 0, 0))
                              .close();
  EXPECT_THAT(read({writeDatabase("a.db3", bag), old}), ElementsAre(1.0, 9.0, 2.0, 3.0));
}

TEST_F(Ros2BagTest, MessagesAreShownByTheirTimesAndKnowHowTheyWereWritten) {
  std::swap(bag.messages[0], bag.messages[2]);
  const auto reader = openBag(writeDatabase("a.db3", bag));
  const auto messages = reader->messages([](const std::string& /*topic*/) { return true; });
  std::vector<Stamp> times;
  std::vector<Stamp> not_before;
  std::vector<MessagePlace> places;
  while (const auto message = messages->next()) {
    times.push_back(message->recorded);
    not_before.push_back(message->not_before);
    places.push_back(message->place);
  }
  using test::milliseconds;
  EXPECT_THAT(times, ElementsAre(milliseconds(1000), milliseconds(2000), milliseconds(3000)));
  EXPECT_THAT(not_before, ElementsAre(milliseconds(3000), milliseconds(3000), milliseconds(3000)));
  EXPECT_THAT(places, ElementsAre(2U, 1U, 0U));
}

TEST_F(Ros2BagTest, TopicsHaveTheTypesOfRos1) {
  bag.topics.push_back({"/points", "sensor_msgs/msg/PointCloud2"});
  bag.topics.push_back({"/silent", "std_msgs/msg/String"});
  bag.messages.push_back({1, std::chrono::seconds(9), "not read"});
  const auto reader = openBag(writeDatabase("a.db3", bag));
  ASSERT_EQ(reader->topics().size(), 2U);
  EXPECT_EQ(reader->topics()[0].type, "sensor_msgs/PointCloud2");
  EXPECT_EQ(reader->topics()[1].type, "tf2_msgs/TFMessage");
  EXPECT_EQ(reader->times()->end, test::milliseconds(9000));
}

TEST_F(Ros2BagTest, ATypeThatWasChangedIsNamed) {
  bag.topics[0].definition = kTransformsDefinition;
  EXPECT_THAT(read({writeDatabase("a.db3", bag)}), ElementsAre(1.0, 2.0, 3.0));
  bag.topics[0].definition += "string more\n";
  for (const std::string& each :
       {writeDatabase("b.db3", bag), folder.write("b.mcap", mcapOf(bag)).string()}) {
    EXPECT_THAT(errorOf(each),
                AllOf(HasSubstr("topic /tf (tf2_msgs/TFMessage) cannot be read"),
                      HasSubstr("geometry_msgs/Quaternion has 'string more' for 'nothing'")));
  }
}

TEST_F(Ros2BagTest, AnotherEncodingIsNamed) {
  bag.topics[0].encoding = "ros1";
  EXPECT_THAT(errorOf(folder.write("a.mcap", mcapOf(bag)).string()),
              HasSubstr("its messages have the encoding 'ros1'; 'cdr' can be read"));
}

TEST_F(Ros2BagTest, SaysWhereAFileBreaksOff) {
  const std::string content = mcapOf(bag, {1});
  const std::string file = folder.write("a.mcap", content.substr(0, content.size() / 2)).string();
  EXPECT_THAT(openBag(file)->notes(), ElementsAre(AllOf(HasSubstr("bag " + file + ": breaks off"),
                                                        HasSubstr("what comes before is read"))));
}

TEST_F(Ros2BagTest, NamesFilesThatCannotBeRead) {
  EXPECT_THAT(errorOf(folder.write("notes.db3", "not a database").string()),
              HasSubstr("is not a bag"));
  std::filesystem::create_directory(path("empty"));
  EXPECT_THAT(errorOf(path("empty")), HasSubstr("is a folder; a bag file is needed"));
  folder.write("empty/metadata.yaml", metadataOf({"a.mcap"}));
  EXPECT_THAT(errorOf(path("empty")), HasSubstr("bag " + path("empty") + ": metadata.yaml names"));
  bag.messages[1].bytes.resize(20);
  EXPECT_THAT(errorOf(writeDatabase("cut.db3", bag)), HasSubstr("a message of /tf cannot be read"));
}

}  // namespace ros2_bag_test
}  // namespace synthetic_dataset::motion

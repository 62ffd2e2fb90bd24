#include "motion/bag/ros2_bag.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "motion/tf/bag_reader.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace ros2_bag_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

class Ros2BagTest : public ::testing::Test {
 protected:
  std::string errorOf(const std::string& name) {
    return messageOf([&] { const BagReader bags({(folder / name).string()}); });
  }

  test::TemporaryFolder folder;
};

TEST_F(Ros2BagTest, FilesAndFoldersAreRecognisedByWhatIsInThem) {
  folder.write("run.db3", std::string("SQLite format 3\0 and so on", 26));
  folder.write("run.mcap", std::string("\x89MCAP0\r\n and so on"));
  std::filesystem::create_directory(folder / "day");
  folder.write("day/metadata.yaml", "rosbag2_bagfile_information:\n");
  for (const std::string name : {"run.db3", "run.mcap", "day"}) {
    const std::string path = (folder / name).string();
    const std::string made = (folder / (name == "day" ? "day" : "run")).string() + ".bag";
    EXPECT_THAT(
        errorOf(name),
        AllOf(HasSubstr("bag " + path + ": is a bag of ROS 2"), HasSubstr("pip install rosbags"),
              HasSubstr("`rosbags-convert --src " + path + " --dst " + made +
                        " --src-typestore ros2_humble --dst-typestore ros1_noetic`")));
  }
}

TEST_F(Ros2BagTest, TheCommandIsOneThatAShellTakes) {
  EXPECT_THAT(convertAdvice("/data/my run.mcap"),
              HasSubstr("--src '/data/my run.mcap' --dst '/data/my run.bag'"));
}

TEST_F(Ros2BagTest, OtherFilesAndFoldersAreNot) {
  folder.write("notes.db3", "not a database");
  std::filesystem::create_directory(folder / "empty");
  EXPECT_THAT(errorOf("notes.db3"), HasSubstr("is not a bag"));
  EXPECT_THAT(errorOf("empty"), HasSubstr("is a folder; a bag file is needed"));
}

}  // namespace ros2_bag_test
}  // namespace synthetic_dataset::motion

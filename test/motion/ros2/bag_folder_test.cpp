#include "motion/ros2/bag_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "motion/ros2_bags.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace bag_folder_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class BagFolder : public ::testing::Test {
 protected:
  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const std::string& file : storageFiles(folder.path().string())) {
      EXPECT_EQ(std::filesystem::path(file).parent_path(), folder.path());
      names.push_back(std::filesystem::path(file).filename().string());
    }
    return names;
  }
  std::string error() {
    return messageOf([&] { (void)names(); });
  }

  test::TemporaryFolder folder;
};

TEST_F(BagFolder, HasTheFilesThatItsMetadataNameInTheirOrder) {
  folder.write("b.mcap", "1");
  folder.write("a.mcap", "2");
  folder.write("c.mcap", "3");
  folder.write("metadata.yaml", metadataOf({"b.mcap", "day/a.mcap"}));
  EXPECT_THAT(names(), ElementsAre("b.mcap", "a.mcap"));
}

TEST_F(BagFolder, WithoutMetadataFilesAreInTheOrderOfTheirNumbers) {
  for (const std::string name : {"day_10.db3", "day_9.db3", "day_0.db3", "notes.txt"}) {
    folder.write(name, "x");
  }
  folder.write("day_9.db3.zstd", "the same");
  EXPECT_THAT(names(), ElementsAre("day_0.db3", "day_9.db3", "day_10.db3"));
}

TEST_F(BagFolder, AFileMayHaveBeenDecompressed) {
  folder.write("a.db3", "x");
  folder.write("metadata.yaml", metadataOf({"a.db3.zstd"}));
  EXPECT_THAT(names(), ElementsAre("a.db3"));
}

TEST_F(BagFolder, NamesWhatIsMissing) {
  EXPECT_THAT(error(), HasSubstr("has no file of rosbag2 (.db3 or .mcap)"));
  folder.write("metadata.yaml", metadataOf({"a.mcap"}));
  EXPECT_THAT(error(), HasSubstr("names the file 'a.mcap', which is not in the folder"));
  folder.write("metadata.yaml", "something: else\n");
  EXPECT_THAT(error(), HasSubstr("no 'rosbag2_bagfile_information'"));
  folder.write("metadata.yaml", "rosbag2_bagfile_information: [\n");
  EXPECT_THAT(error(), HasSubstr("metadata.yaml: line"));
}

}  // namespace bag_folder_test
}  // namespace synthetic_dataset::motion

#include "motion/ros2/mcap_storage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "motion/ros2_bags.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace mcap_storage_test {

using ::testing::HasSubstr;

class McapStorage : public ::testing::Test {
 protected:
  Storage open(const std::string& content) {
    return openMcap(folder.write("a.mcap", content).string());
  }
  std::string errorOf(const std::string& content) {
    return messageOf([&] {
      const Storage storage = open(content);
      for (const StoredMessage& each : storage.messages) (void)storage.read(each.place);
    });
  }

  test::TemporaryFolder folder;
  TestBag bag = drivingBag(5);
};

TEST_F(McapStorage, HasAllMessagesHoweverItIsWritten) {
  std::vector<McapStyle> styles;
  for (const std::size_t chunk : {0, 1, 2, 9}) {
    for (const std::string compression : {"", "lz4", "zstd"}) {
      for (const bool has_index : {false, true}) {
        for (const bool has_summary : {false, true}) {
          styles.push_back({chunk, compression, has_index, has_summary, has_index});
        }
      }
    }
  }
  for (const McapStyle& style : styles) {
    const Storage storage = open(mcapOf(bag, style));
    ASSERT_EQ(storage.topics.size(), 1U);
    EXPECT_EQ(storage.topics[0].name, "/tf");
    EXPECT_EQ(storage.topics[0].type, "tf2_msgs/msg/TFMessage");
    ASSERT_EQ(storage.messages.size(), 5U);
    EXPECT_EQ(storage.note, "");
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(storage.messages[i].recorded, bag.messages[i].recorded);
      EXPECT_EQ(storage.read(storage.messages[i].place), bag.messages[i].bytes);
    }
  }
}

TEST_F(McapStorage, IsReadUpToWhereItBreaksOff) {
  for (const McapStyle& style :
       {McapStyle{0}, McapStyle{2}, McapStyle{2, "zstd"}, McapStyle{1, "lz4", false, false}}) {
    const std::string content = mcapOf(bag, style);
    std::size_t most = 0;
    for (std::size_t size = 8; size < content.size(); size += 7) {
      const Storage storage = open(content.substr(0, size));
      for (const StoredMessage& each : storage.messages) {
        EXPECT_NO_THROW((void)storage.read(each.place));
      }
      EXPECT_GE(storage.messages.size(), most);
      most = storage.messages.size();
      if (most < bag.messages.size()) {
        EXPECT_THAT(storage.note, HasSubstr("breaks off after")) << size;
      }
    }
    EXPECT_EQ(most, 5U);
  }
}

TEST_F(McapStorage, NamesWhatIsDamaged) {
  std::string content = mcapOf(bag, {2, "", true, true, true});
  content[content.find("robot")] = 'x';
  EXPECT_THAT(errorOf(content), HasSubstr("does not have its checksum"));

  content = mcapOf(bag, {2, "zstd"});
  content.replace(content.find("zstd"), 4, "zsty");
  EXPECT_THAT(errorOf(content), HasSubstr("has the compression 'zsty'; lz4, zstd and none"));
}

TEST_F(McapStorage, AnIndexCannotShowAMessageTwiceNorAnythingElse) {
  std::string content = mcapOf(bag, {5, "", true, false, false});
  const std::size_t index = content.rfind("\x07\x56");  // its length: 2 + 4 + 5 * 16
  ASSERT_NE(index, std::string::npos);
  const std::size_t entry = index + 9 + 2 + 4 + 8;
  std::string twice = content;
  twice.replace(entry, 8, content.substr(entry + 16, 8));
  EXPECT_THAT(errorOf(twice), HasSubstr("does not fit its chunk"));
  std::string astray = content;
  ++astray[entry];
  EXPECT_THAT(errorOf(astray), HasSubstr("points to something other than a message"));
  std::string beyond = content;
  beyond[entry + 5] = '\x7F';
  EXPECT_THAT(errorOf(beyond), HasSubstr("does not fit its chunk"));
}

TEST_F(McapStorage, ARecordThatSaysToBeLongerThanTheFileEndsIt) {
  std::string content = mcapOf(bag, {0});
  const std::size_t second = content.find("robot", content.find("robot") + 1);
  content.replace(content.rfind('\x05', second) + 1, 8, std::string(8, '\xFF'));
  const Storage storage = open(content);
  EXPECT_EQ(storage.messages.size(), 1U);
  EXPECT_THAT(storage.note, HasSubstr("breaks off after 1 messages"));
}

TEST_F(McapStorage, RefusesChunksThatBecomeTooLarge) {
  bag.messages[0].bytes = std::string(1000, '\0');
  std::string content = mcapOf(bag, {1, "zstd"});
  const std::size_t chunk = content.find("zstd") - 4 - 4 - 8;
  content.replace(chunk, 8, std::string("\0\0\0\0\1\0\0\0", 8));
  EXPECT_THAT(errorOf(content), HasSubstr("a chunk has more than 1024 MiB"));
}

TEST_F(McapStorage, AMessageNeedsItsChannel) {
  const std::string content = mcapOf(bag, {0});
  const std::string magic = content.substr(0, 8);
  const std::size_t message = content.find('\x05', content.find("cdr"));
  EXPECT_THAT(errorOf(magic + content.substr(message, content.find('\x0F', message) - message)),
              HasSubstr("to a channel that does not exist"));
}

}  // namespace mcap_storage_test
}  // namespace synthetic_dataset::motion

#include "motion/ros2/sqlite_storage.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/sqlite.h"
#include "motion/recorded.h"
#include "motion/ros2_bags.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace sqlite_storage_test {

using base::SqliteDatabase;
using ::testing::HasSubstr;

class SqliteStorage : public ::testing::Test {
 protected:
  [[nodiscard]] std::string file() const { return (folder / "a.db3").string(); }

  std::vector<std::string> namesInFolder() {
    std::vector<std::string> names;
    for (const auto& each : std::filesystem::directory_iterator(folder.path())) {
      names.push_back(each.path().filename().string());
    }
    return names;
  }
  void execute(const std::string& sql) {
    SqliteDatabase(file(), SqliteDatabase::Mode::kCreate).execute(sql);
  }
  std::string errorOf() {
    return messageOf([&] {
      const Storage storage = openSqlite(file());
      for (const StoredMessage& each : storage.messages) (void)storage.read(each.place);
    });
  }

  test::TemporaryFolder folder;
  TestBag bag = drivingBag();
};

TEST_F(SqliteStorage, HasTopicsAndMessagesOfOldAndNewVersions) {
  bag.topics[0].definition = kTransformsDefinition;
  for (const auto version : {SqliteVersion::kDashing, SqliteVersion::kIron}) {
    std::filesystem::remove(file());
    writeSqlite(file(), bag, version);
    const Storage storage = openSqlite(file());
    ASSERT_EQ(storage.topics.size(), 1U);
    EXPECT_EQ(storage.topics[0].name, "/tf");
    EXPECT_EQ(storage.topics[0].encoding, "cdr");
    const bool has_definition = version == SqliteVersion::kIron;
    EXPECT_EQ(storage.topics[0].definition, has_definition ? kTransformsDefinition : "");
    ASSERT_EQ(storage.messages.size(), 3U);
    EXPECT_EQ(storage.read(storage.messages[1].place), bag.messages[1].bytes);
  }
}

TEST_F(SqliteStorage, ReadsAWriteAheadLogAndMakesNoFile) {
  writeSqlite(file(), bag);
  const std::string kept = (folder / "kept.db3").string();
  {
    const SqliteDatabase writer(file(), SqliteDatabase::Mode::kExisting);
    writer.execute("PRAGMA journal_mode = WAL");
    writer.execute("DELETE FROM messages WHERE id = 1");
    std::filesystem::copy(file(), kept);
    std::filesystem::copy(file() + "-wal", kept + "-wal");
  }
  const auto before = namesInFolder();
  {
    const Storage storage = openSqlite(kept);
    EXPECT_EQ(storage.messages.size(), 2U);
    EXPECT_EQ(storage.read(storage.messages[0].place), bag.messages[1].bytes);
    EXPECT_EQ(namesInFolder(), before);
  }
  EXPECT_EQ(namesInFolder(), before);
}

TEST_F(SqliteStorage, ADatabaseThatHasALogNoMoreIsReadWithoutFilesBesideIt) {
  writeSqlite(file(), bag);
  execute("PRAGMA journal_mode = WAL");
  folder.write("a.db3-wal", "");
  EXPECT_EQ(openSqlite(file()).messages.size(), 3U);
  EXPECT_EQ(namesInFolder().size(), 2U);
}

TEST_F(SqliteStorage, NamesAJournalThatWasNotTakenBack) {
  writeSqlite(file(), bag);
  folder.write("a.db3-journal", "something");
  EXPECT_THAT(errorOf(), HasSubstr("an unfinished change to it is in "));
}

TEST_F(SqliteStorage, RefusesOtherDatabases) {
  execute("CREATE TABLE topics (id INTEGER PRIMARY KEY)");
  EXPECT_THAT(errorOf(), HasSubstr("without rosbag2's table 'messages'"));
  execute("CREATE VIEW messages AS SELECT 1 AS id, 2 AS topic_id, 3 AS timestamp, 4 AS data");
  EXPECT_THAT(errorOf(), HasSubstr("'messages', which is not a plain table"));
}

TEST_F(SqliteStorage, RefusesMessagesOfNoTopicAndTimesThatAreNone) {
  writeSqlite(file(), bag);
  execute("UPDATE messages SET topic_id = 7 WHERE id = 2");
  EXPECT_THAT(errorOf(), HasSubstr("to a topic that does not exist"));
  execute("UPDATE messages SET topic_id = 1, timestamp = -5 WHERE id = 2");
  EXPECT_THAT(errorOf(), HasSubstr("which is not a ROS time"));
}

TEST_F(SqliteStorage, NamesAFileThatBreaksOff) {
  bag = drivingBag(200);
  writeSqlite(file(), bag);
  std::filesystem::resize_file(file(), std::filesystem::file_size(file()) / 2);
  EXPECT_THAT(errorOf(), HasSubstr("malformed"));
}

}  // namespace sqlite_storage_test
}  // namespace synthetic_dataset::motion

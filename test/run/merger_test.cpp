#include "run/merger.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "output/manifest/manifest_schema.h"
#include "support/error_messages.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace merger_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::StoppingReporter;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MergerTest : public ::testing::Test {
 protected:
  RunSummary merge(const std::string& folder,
                   const std::vector<std::string>& shard_folders = {}) const {
    Reporter silent;
    return mergeShards(folder, shard_folders, silent, {test::pluginXml()});
  }

  [[nodiscard]] std::vector<std::string> errorsOfMerging(
      const std::string& folder, const std::vector<std::string>& shard_folders = {}) const {
    return test::messagesOf([&] { (void)merge(folder, shard_folders); });
  }

  AllAtOnceRun run;
};

TEST_F(MergerTest, MakesTheBytesOfASingleRunInTheShardsFolder) {
  const auto expected = run.unbroken();
  for (const int index : {2, 0, 1}) (void)run.runShard(index, 3, run.folder());
  merge(run.folder());
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == expected);
}

TEST_F(MergerTest, MakesTheBytesOfASingleRunOfShardsElsewhere) {
  const auto expected = run.unbroken();
  const std::string one = run.input("one");
  const std::string two = run.input("two");
  (void)run.runShard(0, 2, one);
  (void)run.runShard(1, 2, two);
  const auto before = AllAtOnceRun::files(one);
  merge(run.folder(), {two, one});
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == expected);
  EXPECT_TRUE(AllAtOnceRun::files(one) == before);
}

TEST_F(MergerTest, ShardsShareTheScenesAmongThem) {
  std::int64_t scenes = 0;
  for (const int index : {0, 1, 2}) {
    const RunSummary shard = run.runShard(index, 3, run.folder());
    EXPECT_GT(shard.scenes, 0);
    scenes += shard.scenes;
  }
  EXPECT_EQ(scenes, 16);
}

TEST_F(MergerTest, AResumedShardIsAsGoodAsAnUnbrokenOne) {
  const auto expected = run.unbroken();
  Value::Map whole = run.parameters;
  run.parameters["shard"] = Value(Value::Map{{"index", Value(1)}, {"count", Value(2)}});
  StoppingReporter stopping(3);
  (void)run.run(stopping, run.folder());
  run.parameters = whole;
  (void)run.runShard(1, 2, run.folder());
  (void)run.runShard(0, 2, run.folder());
  merge(run.folder());
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == expected);
}

TEST_F(MergerTest, NamesTheShardThatIsMissing) {
  (void)run.runShard(1, 3, run.folder());
  EXPECT_THAT(errorsOfMerging(run.folder()),
              testing::ElementsAre("shard 0/3 is missing", "shard 2/3 is missing"));
}

TEST_F(MergerTest, NamesTheShardThatIsNotComplete) {
  (void)run.runShard(0, 2, run.folder());
  run.parameters["shard"] = Value(Value::Map{{"index", Value(1)}, {"count", Value(2)}});
  StoppingReporter stopping(2);
  (void)run.run(stopping, run.folder());
  EXPECT_THAT(errorsOfMerging(run.folder()),
              Contains(HasSubstr("shard 1/2 in '" + run.folder() + "' is not complete")));
}

TEST_F(MergerTest, NamesTheSettingInWhichShardsDiffer) {
  (void)run.runShard(0, 2, run.folder());
  run.parameters["seed"] = Value(8);
  (void)run.runShard(1, 2, run.folder());
  EXPECT_THAT(errorsOfMerging(run.folder()), Contains(HasSubstr("seed: shard 0/2")));
}

TEST_F(MergerTest, NamesTheInputThatHasChangedSince) {
  (void)run.runShard(0, 1, run.folder());
  const std::string world = run.input("tiny.world");
  const std::string text = test::readFile(world);
  std::ofstream(world) << text << "<!-- the same, but for this -->";
  EXPECT_THAT(errorsOfMerging(run.folder()), Contains(HasSubstr("the file " + world + ": then ")));
}

TEST_F(MergerTest, RefusesShardsOfAnotherVersionOfTheSoftware) {
  (void)run.runShard(0, 1, run.folder());
  base::SqliteDatabase(output::manifestFile(run.folder(), output::Shard{0, 1}),
                       base::SqliteDatabase::Mode::kExisting)
      .execute("UPDATE software SET version = '0.1.0' WHERE name = 'synthetic_dataset'");
  EXPECT_THAT(errorsOfMerging(run.folder()),
              ElementsAre(HasSubstr("software synthetic_dataset: then 0.1.0, now ")));
}

TEST_F(MergerTest, RefusesAShardThatListsFilesElsewhere) {
  (void)run.runShard(0, 1, run.folder());
  const std::string manifest = output::manifestFile(run.folder(), output::Shard{0, 1});
  const base::SqliteDatabase database(manifest, base::SqliteDatabase::Mode::kExisting);
  const std::string first = "(SELECT min(path) FROM file)";
  const std::string precious = run.input("precious.txt");
  database.execute("UPDATE file SET path = '" + precious + "' WHERE path = " + first);
  EXPECT_THAT(errorsOfMerging(run.folder()),
              Contains(AllOf(HasSubstr("lists files outside of it"), HasSubstr(precious))));
  database.execute("UPDATE file SET path = '../precious.txt' WHERE path = '" + precious + "'");
  EXPECT_THAT(errorsOfMerging(run.folder()),
              Contains(HasSubstr("lists the path '../precious.txt'")));
}

TEST_F(MergerTest, RefusesAShardWhoseFolderIsALink) {
  (void)run.runShard(0, 1, run.folder());
  const fs::path images = fs::path(run.folder()) / "link";
  fs::create_directory_symlink(run.input(""), images);
  const base::SqliteDatabase database(output::manifestFile(run.folder(), output::Shard{0, 1}),
                                      base::SqliteDatabase::Mode::kExisting);
  database.execute("UPDATE file SET path = 'link/a.png' WHERE path = (SELECT min(path) FROM file)");
  EXPECT_THAT(errorsOfMerging(run.folder()), Contains(HasSubstr("lists files outside of it")));
}

TEST_F(MergerTest, TellsThatThereAreNoShards) {
  EXPECT_THAT(errorsOfMerging(run.input("")), Contains(HasSubstr("no shards are there")));
}

TEST_F(MergerTest, HasNothingToDoTwice) {
  (void)run.runShard(0, 1, run.folder());
  EXPECT_FALSE(merge(run.folder()).was_complete);
  EXPECT_TRUE(merge(run.folder()).was_complete);
  EXPECT_TRUE(run.runShard(0, 1, run.folder()).was_complete);
}

}  // namespace merger_test
}  // namespace synthetic_dataset::run

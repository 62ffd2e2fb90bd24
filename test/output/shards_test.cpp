/// Datasets that are made in shards.

#include <filesystem>
#include <fstream>
#include <ostream>
#include <set>

#include <gmock/gmock.h>

#include "output/files/run_lock.h"
#include "output/store_fixture.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace shards_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ShardsTest : public testing::Test {
 protected:
  [[nodiscard]] static std::vector<StoreWriter> writersIn(const std::string& folder) {
    return {{"a", "test/A", folder + "/a/", {}}};
  }

  [[nodiscard]] static StoreOptions optionsIn(const std::string& folder,
                                              const std::optional<Shard>& shard = {}) {
    StoreOptions options;
    options.folder = folder;
    options.shard = shard;
    options.sync = Sync::kOff;
    return options;
  }

  static void addScene(DatasetStore& store, const std::string& folder, int index) {
    const std::string name = std::to_string(index);
    const std::string text = "scene " + name;
    SceneFacts facts{index, Stamp{index}};
    facts.objects = {ObjectFacts{}};
    facts.contacts = {{"a", "b", 0.1}};
    facts.draws = {{"floor", name}};
    facts.warnings = {{"a warning"}};
    store.commitScene(facts,
                      {{{0, folder + "/a/" + name, {}, text}}, {{0, "all", "record " + name}}});
  }

  /// Every second scene of six.
  static void makeShard(const std::string& folder, int index) {
    DatasetStore store(optionsIn(folder, Shard{index, 2}), writersIn(folder));
    for (int scene = index; scene < 6; scene += 2) addScene(store, folder, scene);
    store.complete();
  }

  static void finish(DatasetStore& store, const std::string& folder) {
    store.writeDatasetFile(0, folder + "/a/list", [&](std::ostream& list) {
      store.records(0)->forEach("all",
                                [&](std::int64_t, const std::string& text) { list << text; });
    });
    store.complete();
  }

  [[nodiscard]] static std::string singleRun() {
    const test::TemporaryFolder place;
    const std::string folder = place.path().string();
    DatasetStore store(optionsIn(folder), writersIn(folder));
    for (int scene = 0; scene < 6; ++scene) addScene(store, folder, scene);
    finish(store, folder);
    return test::readFile(store.manifestPath());
  }

  static void merge(const std::string& folder, const std::vector<std::string>& shard_folders) {
    StoreOptions options = optionsIn(folder);
    options.source = Source::kShards;
    DatasetStore store(options, writersIn(folder));
    for (int i = 0; i < 2; ++i) {
      store.mergeShard({shard_folders[static_cast<std::size_t>(i)], Shard{i, 2}});
    }
    finish(store, folder);
  }

  test::TemporaryFolder place_;
  std::string folder_ = place_.path().string();
};

TEST_F(ShardsTest, InOneFolderMergeToTheManifestOfASingleRun) {
  makeShard(folder_, 1);
  makeShard(folder_, 0);
  merge(folder_, {folder_, folder_});
  EXPECT_EQ(test::readFile(folder_ + "/manifest.sqlite"), singleRun());
  EXPECT_EQ(test::readFile(folder_ + "/a/list"),
            "record 0record 1record 2record 3record 4record 5");
}

TEST_F(ShardsTest, InFoldersOfTheirOwnMergeToTheManifestOfASingleRun) {
  makeShard(folder_ + "/one", 0);
  makeShard(folder_ + "/two", 1);
  merge(folder_ + "/all", {folder_ + "/one", folder_ + "/two"});
  EXPECT_EQ(test::readFile(folder_ + "/all/manifest.sqlite"), singleRun());
  EXPECT_EQ(test::readFile(folder_ + "/all/a/3"), "scene 3");
  EXPECT_EQ(test::readFile(folder_ + "/two/a/3"), "scene 3");
}

TEST_F(ShardsTest, AMergeThatWasBrokenOffGoesOn) {
  makeShard(folder_ + "/one", 0);
  makeShard(folder_ + "/two", 1);
  {
    StoreOptions options = optionsIn(folder_ + "/all");
    options.source = Source::kShards;
    DatasetStore(options, writersIn(options.folder)).mergeShard({folder_ + "/one", Shard{0, 2}});
  }
  merge(folder_ + "/all", {folder_ + "/one", folder_ + "/two"});
  EXPECT_EQ(test::readFile(folder_ + "/all/manifest.sqlite"), singleRun());
}

TEST_F(ShardsTest, AreNotTakenForForeignFilesByEachOther) {
  makeShard(folder_, 0);
  EXPECT_THAT(errorsOf(optionsIn(folder_, Shard{1, 2}), writersIn(folder_)), IsEmpty());
}

TEST_F(ShardsTest, OfAnotherDivisionAreRefused) {
  makeShard(folder_, 0);
  EXPECT_THAT(errorsOf(optionsIn(folder_, Shard{1, 3}), writersIn(folder_)),
              ElementsAre(HasSubstr("a shard of a run divided differently")));
}

TEST_F(ShardsTest, AreNotMixedWithAWholeRun) {
  makeShard(folder_, 0);
  EXPECT_THAT(errorsOf(optionsIn(folder_), writersIn(folder_)),
              ElementsAre(HasSubstr("synthetic_dataset merge " + folder_)));
  const std::string other = folder_ + "/other";
  { const DatasetStore store(optionsIn(other), writersIn(other)); }
  EXPECT_THAT(errorsOf(optionsIn(other, Shard{0, 2}), writersIn(other)),
              ElementsAre(HasSubstr("a dataset that is not made in shards")));
}

TEST_F(ShardsTest, HaveNothingToDoOnceTheyAreMerged) {
  makeShard(folder_, 0);
  makeShard(folder_, 1);
  merge(folder_, {folder_, folder_});
  fs::remove(folder_ + "/manifest.shard-0-of-2.sqlite");
  fs::remove(folder_ + "/manifest.shard-1-of-2.sqlite");
  EXPECT_TRUE(DatasetStore(optionsIn(folder_, Shard{1, 2}), writersIn(folder_)).wasComplete());
}

TEST_F(ShardsTest, AreReplacedByAWholeRunThatOverwrites) {
  makeShard(folder_, 0);
  StoreOptions options = optionsIn(folder_);
  options.if_exists = IfExists::kOverwrite;
  { const DatasetStore store(options, writersIn(folder_)); }
  EXPECT_FALSE(fs::exists(folder_ + "/a/0"));
  EXPECT_FALSE(fs::exists(folder_ + "/manifest.shard-0-of-2.sqlite"));
}

TEST_F(ShardsTest, LeaveNothingBehindWhenTheyAreKilledAtTheirStart) {
  for (const char* name :
       {".manifest.shard-0-of-2.sqlite.lock", ".manifest.shard-0-of-2.sqlite.tmp",
        ".manifest.shard-1-of-3.sqlite.lock", ".users.lock"}) {
    std::ofstream(folder_ + "/" + name) << "";
  }
  const RunLock alive(folder_ + "/manifest.shard-2-of-3.sqlite");
  { DatasetStore store(optionsIn(folder_), writersIn(folder_)); }
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    left.insert(entry.path().filename().string());
  }
  EXPECT_THAT(left, testing::IsSupersetOf({".users.lock", ".manifest.shard-2-of-3.sqlite.lock"}));
  for (const char* name :
       {".manifest.shard-0-of-2.sqlite.lock", ".manifest.shard-0-of-2.sqlite.tmp",
        ".manifest.shard-1-of-3.sqlite.lock"}) {
    EXPECT_EQ(left.count(name), 0U) << name;
  }
}

TEST_F(ShardsTest, OverwriteOnlyWhatIsTheirOwn) {
  makeShard(folder_, 0);
  makeShard(folder_, 1);
  StoreOptions options = optionsIn(folder_, Shard{1, 2});
  options.if_exists = IfExists::kOverwrite;
  { const DatasetStore store(options, writersIn(folder_)); }
  EXPECT_TRUE(fs::exists(folder_ + "/a/0"));
  EXPECT_FALSE(fs::exists(folder_ + "/a/1"));
}

TEST_F(ShardsTest, AMissingFileStopsAMerge) {
  makeShard(folder_ + "/one", 0);
  makeShard(folder_ + "/two", 1);
  fs::remove(folder_ + "/one/a/2");
  try {
    merge(folder_ + "/all", {folder_ + "/one", folder_ + "/two"});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(folder_ + "/one/a/2"));
  }
}

}  // namespace shards_test
}  // namespace synthetic_dataset::output

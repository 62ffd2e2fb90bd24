/// Resuming a dataset that a run left unfinished.

#include <csignal>
#include <filesystem>
#include <ostream>

#include <gmock/gmock.h>

#include "output/manifest/manifest.h"
#include "output/store_fixture.h"
#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace resume_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ResumeTest : public StoreFixture {
 protected:
  [[nodiscard]] static SceneFacts factsOf(int index) {
    SceneFacts facts{index, Stamp{index}};
    facts.contacts = {{"a", "b", 0.1}};
    facts.draws = {{"floor", std::to_string(index)}};
    return facts;
  }

  void addScene(DatasetStore& store, int index) const {
    const std::string name = std::to_string(index);
    store.commitScene(factsOf(index),
                      {{text("a/" + name, "a of " + name), text("b/" + name, "b of " + name)},
                       {{0, "all", "record " + name}}});
  }

  void finish(DatasetStore& store) const {
    store.writeDatasetFile(0, path("list.txt"), [](std::ostream& list) { list << "all"; });
    store.complete();
  }

  /// The manifest of an uninterrupted run.
  [[nodiscard]] std::string unbrokenManifest(int scenes) const {
    const test::TemporaryFolder other;
    const std::string folder = other.path().string();
    StoreOptions options;
    options.folder = folder;
    DatasetStore store(options, {{"a", "test/A", folder + "/a/", {folder + "/list.txt"}},
                                 {"b", "test/B", folder + "/b/", {}}});
    for (int index = 0; index < scenes; ++index) {
      const std::string name = std::to_string(index);
      store.commitScene(factsOf(index), {{{0, folder + "/a/" + name, {}, "a of " + name},
                                          {1, folder + "/b/" + name, {}, "b of " + name}},
                                         {{0, "all", "record " + name}}});
    }
    store.writeDatasetFile(0, folder + "/list.txt", [](std::ostream& list) { list << "all"; });
    store.complete();
    return test::readFile(store.manifestPath());
  }

  /// A run that is killed after its first scenes.
  void killedAfter(int scenes) {
    const auto run = [&] {
      auto store = makeStore();
      for (int index = 0; index < scenes; ++index) addScene(*store, index);
      std::raise(SIGKILL);
    };
    EXPECT_EXIT(run(), testing::KilledBySignal(SIGKILL), "");
  }
};

TEST_F(ResumeTest, KnowsTheScenesThatAreThere) {
  killedAfter(2);
  auto store = makeStore();
  EXPECT_TRUE(store->hasScene(0));
  EXPECT_TRUE(store->hasScene(1));
  EXPECT_FALSE(store->hasScene(2));
  EXPECT_EQ(store->counts().scenes, 2);
}

TEST_F(ResumeTest, GivesTheBytesOfAnUnbrokenRun) {
  killedAfter(2);
  auto store = makeStore();
  addScene(*store, 2);
  addScene(*store, 3);
  finish(*store);
  EXPECT_EQ(test::readFile(path("manifest.sqlite")), unbrokenManifest(4));
}

TEST_F(ResumeTest, GivesTheSameBytesWhateverTheOrderOfTheScenes) {
  auto store = makeStore();
  for (const int index : {3, 0, 2, 1}) addScene(*store, index);
  finish(*store);
  EXPECT_EQ(test::readFile(path("manifest.sqlite")), unbrokenManifest(4));
}

TEST_F(ResumeTest, OfACompleteDatasetHasNothingToDo) {
  finish(*makeStore());
  const std::string before = test::readFile(path("manifest.sqlite"));
  EXPECT_TRUE(makeStore()->wasComplete());
  EXPECT_EQ(test::readFile(path("manifest.sqlite")), before);
}

TEST_F(ResumeTest, DropsTheSceneThatWasInWork) {
  {
    Manifest manifest = Manifest::create(folder_.path().string(), {}, Sync::kBatch, writers(), {});
    manifest.announceScene({0, Stamp{0}}, {{path("a/0"), 0, 6}, {path("b/0"), 1, 6}});
    folder_.write("a/0", "a of 0");
    folder_.write("b/.0.tmp", "b o");
  }
  auto store = makeStore();
  EXPECT_FALSE(store->hasScene(0));
  EXPECT_THAT(tree(), ElementsAre("a", "b"));
  addScene(*store, 0);
  finish(*store);
  EXPECT_EQ(test::readFile(path("manifest.sqlite")), unbrokenManifest(1));
}

TEST_F(ResumeTest, DropsScenesThatAPowerCutSpoilt) {
  killedAfter(3);
  fs::resize_file(path("a/1"), 0);
  auto store = makeStore();
  EXPECT_TRUE(store->hasScene(0));
  EXPECT_FALSE(store->hasScene(1));
  EXPECT_TRUE(store->hasScene(2));
  EXPECT_FALSE(fs::exists(path("b/1")));
  addScene(*store, 1);
  finish(*store);
  EXPECT_EQ(test::readFile(path("manifest.sqlite")), unbrokenManifest(3));
}

TEST_F(ResumeTest, DoesNotReadScenesAgainThatWereForcedToTheDisk) {
  StoreOptions synced = options();
  synced.sync = Sync::kScene;
  addScene(*makeStore(synced), 0);
  EXPECT_THAT(query("SELECT state FROM scene"), ElementsAre("complete"));
}

TEST_F(ResumeTest, DropsSafeScenesWhoseFilesSomebodyRemoved) {
  StoreOptions synced = options();
  synced.sync = Sync::kScene;
  addScene(*makeStore(synced), 0);
  fs::remove(path("a/0"));
  EXPECT_FALSE(makeStore()->hasScene(0));
}

TEST_F(ResumeTest, RemovesTheLockOfARunThatWasKilledAtItsVeryEnd) {
  finish(*makeStore());
  folder_.write(".manifest.sqlite.lock", "");
  EXPECT_TRUE(makeStore()->wasComplete());
  EXPECT_FALSE(fs::exists(path(".manifest.sqlite.lock")));
}

TEST_F(ResumeTest, DoesNotMindAManifestThatWasAboutToBeMade) {
  folder_.write(".manifest.sqlite.tmp", "half a mani");
  finish(*makeStore());
  EXPECT_EQ(test::readFile(path("manifest.sqlite")), unbrokenManifest(0));
}

TEST_F(ResumeTest, MakesTheFilesOfTheWholeDatasetAnew) {
  {
    auto store = makeStore();
    addScene(*store, 0);
    store->writeDatasetFile(0, path("list.txt"), [](std::ostream& list) { list << "half"; });
  }
  auto store = makeStore();
  finish(*store);
  EXPECT_EQ(test::readFile(path("list.txt")), "all");
  EXPECT_EQ(test::readFile(path("manifest.sqlite")), unbrokenManifest(1));
}

TEST_F(ResumeTest, IsRefusedWithOtherSettingsThatAreNamed) {
  RunDescription then;
  then.settings["camera/far"] = {"100.0", false};
  { const DatasetStore store(options(), writers(), then); }
  RunDescription now = then;
  now.settings["camera/far"].value = "50.0";
  try {
    const DatasetStore store(options(), writers(), now);
    ADD_FAILURE();
  } catch (const ErrorList& error) {
    EXPECT_THAT(error.messages(),
                ElementsAre(AllOf(HasSubstr("was begun with other settings: camera/far: then "
                                            "100.0, now 50.0"),
                                  HasSubstr("if_exists: overwrite"))));
  }
}

TEST_F(ResumeTest, IsRefusedToAnotherVersionOfTheSoftware) {
  RunDescription then;
  then.software["synthetic_dataset"] = "0.1.0";
  { const DatasetStore store(options(), writers(), then); }
  RunDescription now = then;
  now.software["synthetic_dataset"] = "0.2.0";
  EXPECT_THAT(test::messagesOf([&] { const DatasetStore store(options(), writers(), now); }),
              ElementsAre(AllOf(HasSubstr("software synthetic_dataset: then 0.1.0, now 0.2.0"),
                                HasSubstr("if_exists: overwrite"))));
}

TEST_F(ResumeTest, IsRefusedWhereAWriterWritesElsewhere) {
  makeStore();
  auto moved = writers();
  moved[1].output_folder = path("c/");
  EXPECT_THAT(errorsOf(options(), moved), Each(HasSubstr("b/output_folder: then")));
}

TEST_F(ResumeTest, IsRefusedWhileTheRunGoesOn) {
  const auto store = makeStore();
  EXPECT_THAT(errorsOf(options(), writers()), ElementsAre(HasSubstr("another run is writing")));
}

TEST_F(ResumeTest, LeavesNoFileOfItsOwn) {
  killedAfter(1);
  finish(*makeStore());
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("a", "b", "list.txt", "manifest.sqlite"));
}

}  // namespace resume_test
}  // namespace synthetic_dataset::output

#include "output/earlier_dataset.h"

#include <csignal>
#include <filesystem>
#include <ostream>

#include <gmock/gmock.h>

#include "output/manifest/manifest.h"
#include "output/store_fixture.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace earlier_dataset_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class EarlierDatasetTest : public StoreFixture {
 protected:
  /// A complete run of two scenes with a main list.
  void earlierRun() {
    auto store = makeStore();
    for (const std::string name : {"0", "1"}) {
      store->commitScene({std::stoi(name), Stamp{0}},
                         {{text("a/deep/" + name + ".txt", name), text("b/" + name, name)}, {}});
    }
    store->writeDatasetFile(0, path("list.txt"), [](std::ostream& list) { list << "old"; });
    store->complete();
  }

  [[nodiscard]] std::vector<std::string> errors(IfExists if_exists) const {
    StoreOptions options;
    options.folder = folder_.path().string();
    options.if_exists = if_exists;
    return errorsOf(options, writers());
  }
};

TEST_F(EarlierDatasetTest, IsRefusedWhenAskedFor) {
  earlierRun();
  EXPECT_THAT(
      errors(IfExists::kError),
      ElementsAre(
          AllOf(HasSubstr("'" + path("manifest.sqlite") + "' lists a complete dataset of 2 scenes"),
                HasSubstr("choose another folder"), HasSubstr("if_exists: overwrite"))));
  EXPECT_EQ(test::readFile(path("a/deep/1.txt")), "1");
}

TEST_F(EarlierDatasetTest, IsCalledUnfinishedWhenItIs) {
  makeStore();
  EXPECT_THAT(errors(IfExists::kError),
              ElementsAre(HasSubstr("an unfinished dataset of 0 scenes")));
}

TEST_F(EarlierDatasetTest, IsRemovedWhenOverwriting) {
  earlierRun();
  auto store = makeStore(IfExists::kOverwrite);
  EXPECT_THAT(tree(), ElementsAre("a", "b"));
  store->commitScene({0, Stamp{0}}, {{text("a/0.txt", "new")}, {}});
  EXPECT_THAT(query("SELECT path FROM file"), ElementsAre("a/0.txt"));
}

TEST_F(EarlierDatasetTest, IsKeptWholeWhenAFileNobodyListsIsInTheWay) {
  earlierRun();
  folder_.write("b/notes/mine.txt", "precious");
  EXPECT_THAT(errors(IfExists::kOverwrite),
              ElementsAre(AllOf(HasSubstr("writer 'b'"), HasSubstr("'notes/mine.txt'"),
                                HasSubstr("no manifest lists"))));
  EXPECT_EQ(test::readFile(path("b/notes/mine.txt")), "precious");
  EXPECT_EQ(test::readFile(path("a/deep/0.txt")), "0");
}

TEST_F(EarlierDatasetTest, MayHaveAReportAmongItsFiles) {
  const std::vector<StoreWriter> one = {{"a", "test/A", folder_.path().string() + "/", {}}};
  StoreOptions chosen = options();
  DatasetStore(chosen, one, {}).commitScene({0, Stamp{0}}, {{text("a.txt", "0")}, {}});
  for (const std::string name : {"report.html", ".report.html.tmp"}) folder_.write(name, "page");
  for (const IfExists if_exists : {IfExists::kResume, IfExists::kOverwrite}) {
    chosen.if_exists = if_exists;
    EXPECT_THAT(errorsOf(chosen, one), IsEmpty());
    EXPECT_EQ(test::readFile(path("report.html")), "page");
  }
  folder_.write("b/report.html", "another's");
  EXPECT_THAT(errorsOf(chosen, one), ElementsAre(HasSubstr("'b/report.html'")));
}

TEST_F(EarlierDatasetTest, IsKeptWholeWhenTheNewRunCannotBegin) {
  earlierRun();
  folder_.write("wall", "");
  StoreOptions options;
  options.folder = folder_.path().string();
  options.if_exists = IfExists::kOverwrite;
  auto both = writers();
  both[1].output_folder = path("wall/b/");
  EXPECT_THAT(errorsOf(options, both), ElementsAre(HasSubstr("Not a directory")));
  EXPECT_EQ(test::readFile(path("a/deep/0.txt")), "0");
}

TEST_F(EarlierDatasetTest, KeepsFilesOutsideTheWritersFolders) {
  earlierRun();
  folder_.write("readme.txt", "mine");
  makeStore(IfExists::kOverwrite);
  EXPECT_EQ(test::readFile(path("readme.txt")), "mine");
}

TEST_F(EarlierDatasetTest, FilesWithoutAManifestAreRefusedEvenWhenOverwriting) {
  for (const char* name : {"1", "2", "3", "4", "5"}) folder_.write("a/" + std::string(name), "");
  for (const IfExists if_exists : {IfExists::kError, IfExists::kOverwrite}) {
    EXPECT_THAT(errors(if_exists), ElementsAre(AllOf(HasSubstr("writer 'a'"), HasSubstr("and more"),
                                                     HasSubstr("another output_folder"))));
  }
}

TEST_F(EarlierDatasetTest, AUserFileIsReplacedOnlyWhenOverwriting) {
  folder_.write("list.txt", "older");
  EXPECT_THAT(errors(IfExists::kError),
              ElementsAre(AllOf(HasSubstr("'" + path("list.txt") + "' exists"),
                                HasSubstr("if_exists: overwrite"))));
  auto store = makeStore(IfExists::kOverwrite);
  EXPECT_EQ(test::readFile(path("list.txt")), "older");
  store->writeDatasetFile(0, path("list.txt"), [](std::ostream& list) { list << "new"; });
  EXPECT_EQ(test::readFile(path("list.txt")), "new");
}

TEST_F(EarlierDatasetTest, AUserFileThatIsAFolderIsAnError) {
  fs::create_directories(path("list.txt"));
  EXPECT_THAT(errors(IfExists::kOverwrite),
              ElementsAre(HasSubstr("'" + path("list.txt") + "' is a folder")));
}

TEST_F(EarlierDatasetTest, ADamagedManifestIsAnError) {
  folder_.write("manifest.sqlite", "this is no database, whatever its name says");
  EXPECT_THAT(errors(IfExists::kOverwrite),
              ElementsAre(AllOf(HasSubstr("of an earlier run cannot be read"),
                                HasSubstr(path("manifest.sqlite")), HasSubstr("not a database"))));
}

TEST_F(EarlierDatasetTest, AnotherVersionsManifestIsAnError) {
  earlierRun();
  (void)query("UPDATE run SET value = '99' WHERE key = 'format_version'");
  EXPECT_THAT(errors(IfExists::kOverwrite),
              ElementsAre(HasSubstr(
                  "format version is '99', and this release reads 7, and 4 of release 0.1.0")));
}

TEST_F(EarlierDatasetTest, OfTheVersionBeforeIsRemovedWhenOverwriting) {
  earlierRun();
  (void)query("UPDATE run SET value = '4' WHERE key = 'format_version'");
  makeStore(IfExists::kOverwrite);
  EXPECT_THAT(tree(), ElementsAre("a", "b"));
}

TEST_F(EarlierDatasetTest, AManifestWithARowThatNoTableTakesNamesIt) {
  earlierRun();
  (void)query(
      "PRAGMA ignore_check_constraints = ON; UPDATE scene SET width = 0 WHERE \"index\" = 1");
  EXPECT_THAT(errors(IfExists::kOverwrite),
              ElementsAre(HasSubstr("scene: sizes that no image has: scene 1")));
}

TEST_F(EarlierDatasetTest, AManifestWhoseFactsDoNotAgreeIsAnError) {
  earlierRun();
  (void)query("DELETE FROM run WHERE key = 'state'");
  EXPECT_THAT(errors(IfExists::kOverwrite), ElementsAre(HasSubstr("its state is ''")));
  (void)query("INSERT INTO run VALUES ('state', 'complete')");
  (void)query("INSERT INTO setting VALUES ('seed', '7', 0)");
  EXPECT_THAT(errors(IfExists::kOverwrite), ElementsAre(HasSubstr("its settings_digest")));
}

TEST_F(EarlierDatasetTest, AManifestWithoutOneOfItsTablesIsAnError) {
  earlierRun();
  (void)query("DROP TABLE record");
  EXPECT_THAT(errors(IfExists::kOverwrite), ElementsAre(HasSubstr("no such table: record")));
  (void)query("DROP TABLE draw");
  EXPECT_THAT(errors(IfExists::kOverwrite), ElementsAre(HasSubstr("no such table: draw")));
}

TEST_F(EarlierDatasetTest, AManifestThatPointsElsewhereRemovesNothing) {
  earlierRun();
  (void)query("UPDATE file SET path = '../outside' WHERE path = 'b/0'");
  EXPECT_THAT(errors(IfExists::kOverwrite), ElementsAre(HasSubstr("lists the path '../outside'")));
}

TEST_F(EarlierDatasetTest, AManifestThatListsSomebodyElsesFilesRemovesNothing) {
  earlierRun();
  const test::TemporaryFolder home;
  const std::string precious = home.write("precious.txt", "").string();
  (void)query("UPDATE file SET path = '" + precious + "' WHERE path = 'b/0'");
  EXPECT_THAT(errors(IfExists::kOverwrite),
              Contains(AllOf(HasSubstr("lists files outside of it"), HasSubstr(precious))));
  EXPECT_TRUE(fs::exists(precious));
}

TEST_F(EarlierDatasetTest, IsNotGoneOnWithWhereItListsSomebodyElsesFiles) {
  earlierRun();
  fs::remove(path("a/deep/1.txt"));  // something is to be done
  const test::TemporaryFolder home;
  const std::string precious = home.write("precious.txt", "").string();
  (void)query("UPDATE file SET path = '" + precious + "' WHERE path = 'b/0'");
  EXPECT_THAT(errors(IfExists::kResume),
              ElementsAre(AllOf(HasSubstr("lists files outside of it"), HasSubstr(precious))));
  EXPECT_TRUE(fs::exists(precious));
}

TEST_F(EarlierDatasetTest, IsNeitherGoneOnWithNorRemovedThroughALinkToAFolder) {
  earlierRun();
  const test::TemporaryFolder home;
  (void)home.write("1.txt", "precious");
  fs::remove_all(path("a/deep"));
  fs::create_directory_symlink(home.path(), path("a/deep"));
  fs::remove(path("b/0"));  // something is to be done
  for (const IfExists if_exists : {IfExists::kResume, IfExists::kOverwrite}) {
    EXPECT_THAT(errors(if_exists), Contains(HasSubstr("lists files outside of it")));
    EXPECT_EQ(test::readFile((home / "1.txt").string()), "precious");
  }
}

TEST_F(EarlierDatasetTest, OfAnEarlierFormatVersionIsNotGoneOnWith) {
  earlierRun();
  for (const char* earlier : {"4"}) {
    (void)query("UPDATE run SET value = '" + std::string(earlier) +
                "' WHERE key = 'format_version'");
    EXPECT_THAT(errors(IfExists::kResume),
                ElementsAre(HasSubstr("its manifest has another format version")))
        << earlier;
  }
}

TEST_F(EarlierDatasetTest, CanBeMovedAndThenOverwritten) {
  earlierRun();
  const test::TemporaryFolder other;
  fs::rename(folder_.path(), other / "moved");
  StoreOptions options;
  options.folder = (other / "moved").string();
  options.if_exists = IfExists::kOverwrite;
  EXPECT_THAT(errorsOf(options, {{"a", "test/A", options.folder + "/a/", {}}}), IsEmpty());
  EXPECT_FALSE(fs::exists(other / "moved/a/deep"));
  EXPECT_FALSE(fs::exists(other / "moved/b"));
}

TEST_F(EarlierDatasetTest, OfAKilledRunIsOverwrittenWithAllThatItLeft) {
  const auto killedRun = [this] {
    auto store = makeStore();
    store->commitScene({0, Stamp{0}}, {{text("a/0.txt", "0")}, {}});
    store->writeDatasetFile(0, path("a/index"), [](std::ostream& list) {
      list << "half" << std::flush;
      std::raise(SIGKILL);
    });
  };
  EXPECT_EXIT(killedRun(), testing::KilledBySignal(SIGKILL), "");
  EXPECT_THAT(tree(), ElementsAre("a", "a/.index.tmp", "a/0.txt", "b"));
  makeStore(IfExists::kOverwrite);
  EXPECT_THAT(tree(), ElementsAre("a", "b"));
}

TEST_F(EarlierDatasetTest, OfARunKilledAmidASceneListsThatScenesFilesButNotTheScene) {
  {
    // The state in which commitScene is about to rename the second of two files.
    Manifest manifest = Manifest::create(folder_.path().string(), {}, Sync::kBatch, writers(), {});
    manifest.announceScene({0, Stamp{0}}, {{path("a/0.txt"), 0, 1}, {path("a/1.txt"), 0, 1}});
    folder_.write("a/0.txt", "0");
    folder_.write("a/.1.txt.tmp", "1");
  }
  EXPECT_THAT(errors(IfExists::kError),
              ElementsAre(HasSubstr("an unfinished dataset of 0 scenes")));
  makeStore(IfExists::kOverwrite);
  EXPECT_THAT(tree(), ElementsAre("a", "b"));
}

}  // namespace earlier_dataset_test
}  // namespace synthetic_dataset::output

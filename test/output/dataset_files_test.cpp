#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "output/dataset_store.h"
#include "output/store_fixture.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace dataset_files_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A store with one scene: `a/0.txt` of writer `a`, `b/0.txt` of writer `b`.
class DatasetFiles : public StoreFixture {
 protected:
  void SetUp() override {
    store_ = makeStore();
    store_->commitScene({0, Stamp{1}}, {{text("a/0.txt", "of a"), text("b/0.txt", "of b")}, {}});
  }

  /// The message of the error that an action throws.
  template <class Action>
  static std::string failureOf(const Action& action) {
    try {
      action();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "no error";
  }

  [[nodiscard]] std::vector<std::string> datasetRows() const {
    return query("SELECT path, writer, bytes, linked_to FROM file WHERE scene IS NULL");
  }

  std::unique_ptr<DatasetStore> store_;
};

TEST_F(DatasetFiles, AreNotLeftWhereTheManifestGoesMeanwhile) {
  const auto write = [&](const std::string& file) {
    fs::remove(path("manifest.sqlite"));
    std::ofstream(file) << "content";
  };
  EXPECT_THAT(failureOf([&] { store_->writeDatasetFileByName(0, path("a/all"), write); }),
              HasSubstr("has been removed or replaced"));
  EXPECT_FALSE(fs::exists(path("a/all")));
}

TEST_F(DatasetFiles, AreWrittenByALibraryUnderAnotherName) {
  std::string given;
  store_->writeDatasetFileByName(1, path("b/deep/model.bin"), [&](const std::string& file) {
    given = file;
    std::ofstream(file) << "12345";
  });
  EXPECT_EQ(given, path("b/deep/.model.bin.tmp"));
  EXPECT_EQ(test::readFile(path("b/deep/model.bin")), "12345");
  EXPECT_THAT(tree(), ElementsAre("a", "a/0.txt", "b", "b/0.txt", "b/deep", "b/deep/model.bin"));
  EXPECT_THAT(datasetRows(), ElementsAre("b/deep/model.bin|1|5|NULL"));
  EXPECT_EQ(store_->counts().files, 3);
  EXPECT_EQ(store_->counts().bytes, 13);
}

TEST_F(DatasetFiles, LeaveNothingWhenTheLibraryFails) {
  const auto fail = [](const std::string& file) {
    std::ofstream(file) << "half";
    throw std::range_error("no more");
  };
  EXPECT_EQ(failureOf([&] { store_->writeDatasetFileByName(0, path("a/x"), fail); }), "no more");
  EXPECT_THAT(tree(), ElementsAre("a", "a/0.txt", "b", "b/0.txt"));
  EXPECT_THAT(datasetRows(), IsEmpty());
  EXPECT_EQ(store_->counts().files, 2);
}

TEST_F(DatasetFiles, AreTriedAgainAfterAFailure) {
  EXPECT_NE(failureOf([&] {
              store_->writeDatasetFileByName(0, path("a/x"), [](const std::string& /*file*/) {});
            }),
            "no error");
  store_->writeDatasetFileByName(0, path("a/x"),
                                 [](const std::string& file) { std::ofstream(file) << "x"; });
  EXPECT_THAT(datasetRows(), ElementsAre("a/x|0|1|NULL"));
}

TEST_F(DatasetFiles, DoNotReplaceASceneFile) {
  const auto write = [](const std::string& file) { std::ofstream(file) << "other"; };
  EXPECT_THAT(failureOf([&] { store_->writeDatasetFileByName(0, path("a/0.txt"), write); }),
              HasSubstr("'" + path("a/0.txt") + "' belongs to scene 0 of writer 'a'"));
  EXPECT_THAT(failureOf([&] { store_->linkDatasetFile(0, path("a/0.txt"), path("a/0.txt")); }),
              HasSubstr("belongs to scene 0 of writer 'a'"));
  EXPECT_EQ(test::readFile(path("a/0.txt")), "of a");
  EXPECT_THAT(query("SELECT path FROM file"), ElementsAre("a/0.txt", "b/0.txt"));
}

TEST_F(DatasetFiles, AreLinkedToASceneFile) {
  store_->linkDatasetFile(0, path("a/train/000000.txt"), path("a/0.txt"));
  EXPECT_TRUE(fs::equivalent(path("a/0.txt"), path("a/train/000000.txt")));
  EXPECT_THAT(datasetRows(), ElementsAre("a/train/000000.txt|0|4|a/0.txt"));
  EXPECT_EQ(store_->counts().files, 3);
  EXPECT_EQ(store_->counts().bytes, 8) << "a link has no bytes of its own";
}

TEST_F(DatasetFiles, StayWhenTheSceneFileTheyAreLinkedToGoes) {
  store_->linkDatasetFile(0, path("a/copy.txt"), path("a/0.txt"));
  fs::remove(path("a/0.txt"));
  EXPECT_EQ(test::readFile(path("a/copy.txt")), "of a");
}

TEST_F(DatasetFiles, AreNotLinkedToWhatTheWriterDidNotMake) {
  folder_.write("a/mine.txt", "of the user");
  store_->writeDatasetFileByName(0, path("a/all"),
                                 [](const std::string& file) { std::ofstream(file) << "x"; });
  for (const char* other : {"b/0.txt", "a/mine.txt", "a/none.txt", "a/all"}) {
    EXPECT_THAT(failureOf([&] { store_->linkDatasetFile(0, path("a/link"), path(other)); }),
                AllOf(HasSubstr(path(other)), HasSubstr("not a file that the writer 'a' made")));
  }
  EXPECT_FALSE(fs::exists(path("a/link")));
  EXPECT_THAT(datasetRows(), ElementsAre("a/all|0|1|NULL"));
}

TEST_F(DatasetFiles, LeaveNothingOfALinkThatFails) {
  fs::create_directories(path("a/link"));  // a folder where the link should go
  EXPECT_THAT(failureOf([&] { store_->linkDatasetFile(0, path("a/link"), path("a/0.txt")); }),
              HasSubstr("cannot write '" + path("a/link") + "'"));
  EXPECT_THAT(tree(), ElementsAre("a", "a/0.txt", "a/link", "b", "b/0.txt"));
  EXPECT_THAT(datasetRows(), IsEmpty());
}

TEST_F(DatasetFiles, GoWithTheirDatasetWhenItIsReplaced) {
  store_->linkDatasetFile(0, path("a/link"), path("a/0.txt"));
  store_.reset();
  makeStore(IfExists::kOverwrite);
  EXPECT_THAT(tree(), ElementsAre("a", "b"));
}

TEST_F(DatasetFiles, ReadASceneFileOfTheSameWriterOnly) {
  EXPECT_EQ(store_->readSceneFile(0, path("a/0.txt")), "of a");
  EXPECT_EQ(store_->readSceneFile(1, path("b/0.txt")), "of b");
  EXPECT_THAT(failureOf([&] { (void)store_->readSceneFile(0, path("b/0.txt")); }),
              HasSubstr("not a file that the writer 'a' made for a scene"));
  EXPECT_THAT(failureOf([&] { (void)store_->readSceneFile(0, "/etc/hostname"); }),
              HasSubstr("'/etc/hostname'"));
}

TEST_F(DatasetFiles, TellOfASceneFileThatHasGone) {
  fs::remove(path("a/0.txt"));
  EXPECT_THAT(failureOf([&] { (void)store_->readSceneFile(0, path("a/0.txt")); }),
              AllOf(HasSubstr("cannot read '" + path("a/0.txt") + "'"), Not(HasSubstr("no file"))));
}

TEST_F(DatasetFiles, AreReadAndLinkedWhileOneIsWritten) {
  const auto records = store_->records(0);
  store_->commitScene({1, Stamp{2}}, {{text("a/1.txt", " and more")}, {{0, "all", "a/1.txt"}}});
  store_->writeDatasetFileByName(0, path("a/all"), [&](const std::string& file) {
    std::ofstream all(file);
    all << store_->readSceneFile(0, path("a/0.txt"));
    records->forEach("all", [&](std::int64_t, const std::string& scene_file) {
      all << store_->readSceneFile(0, path(scene_file));
      store_->linkDatasetFile(0, path("a/link"), path(scene_file));
    });
  });
  EXPECT_EQ(test::readFile(path("a/all")), "of a and more");
  EXPECT_EQ(test::readFile(path("a/link")), " and more");
}

}  // namespace dataset_files_test
}  // namespace synthetic_dataset::output

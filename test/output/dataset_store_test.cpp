#include "output/dataset_store.h"

#include <atomic>
#include <filesystem>
#include <ostream>
#include <thread>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "base/sqlite.h"
#include "output/store_fixture.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace dataset_store_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A picture that differs from scene to scene.
cv::Mat picture(int seed) {
  cv::Mat image(48, 64, CV_8UC3);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      image.at<cv::Vec3b>(row, column) = {static_cast<uchar>(row * 5 + seed),
                                          static_cast<uchar>(column * 3),
                                          static_cast<uchar>(row ^ column)};
    }
  }
  return image;
}

class DatasetStoreTest : public StoreFixture {
 protected:
  /// The message of the error that commitScene throws.
  static std::string failureOf(DatasetStore& store, std::int64_t index, const SceneFiles& files) {
    try {
      store.commitScene({index, Stamp{0}}, files);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  [[nodiscard]] SceneFiles someScene(int index) const {
    const cv::Mat pixels = picture(index);
    const std::string name = std::to_string(index);
    return {{image("a/" + name + ".png", pixels), text("a/" + name + ".txt", "label " + name),
             image("b/x/" + name + ".png", pixels)},
            {{0, "all", "record " + name}, {1, "all", "other"}, {0, "all", "second"}}};
  }
};

TEST_F(DatasetStoreTest, WritesTextAsGiven) {
  const std::string content("line\n\0after a zero byte", 22);
  makeStore()->commitScene({0, Stamp{0}}, {{text("a/0.txt", content)}, {}});
  EXPECT_EQ(test::readFile(path("a/0.txt")), content);
}

TEST_F(DatasetStoreTest, WritesImagesThatReadBackPixelForPixel) {
  const cv::Mat pixels = picture(1);
  makeStore()->commitScene({0, Stamp{0}}, {{image("a/0.png", pixels)}, {}});
  const cv::Mat read = cv::imread(path("a/0.png"), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.size(), pixels.size());
  ASSERT_EQ(read.type(), pixels.type());
  EXPECT_EQ(cv::norm(read, pixels, cv::NORM_L1), 0.0);
}

TEST_F(DatasetStoreTest, LinksThePixelsThatAreAskedForTwice) {
  const cv::Mat pixels = picture(0);
  auto store = makeStore();
  store->commitScene({0, Stamp{0}},
                     {{image("a/0.png", pixels), image("b/deep/0.png", pixels)}, {}});
  EXPECT_TRUE(fs::equivalent(path("a/0.png"), path("b/deep/0.png")));
  EXPECT_EQ(fs::hard_link_count(path("a/0.png")), 2u);
  EXPECT_EQ(store->counts().files, 2);
  EXPECT_EQ(store->counts().bytes, static_cast<std::int64_t>(fs::file_size(path("a/0.png"))));
}

TEST_F(DatasetStoreTest, DoesNotLinkPartsOfOneImageWithEachOther) {
  const cv::Mat pixels = picture(0);
  makeStore()->commitScene(
      {0, Stamp{0}}, {{image("a/0.png", pixels), image("b/0.png", pixels.colRange(0, 32))}, {}});
  EXPECT_FALSE(fs::equivalent(path("a/0.png"), path("b/0.png")));
  EXPECT_EQ(cv::imread(path("b/0.png")).cols, 32);
}

TEST_F(DatasetStoreTest, EncodesOnePictureInTwoFormats) {
  const cv::Mat pixels = picture(0);
  makeStore()->commitScene({0, Stamp{0}},
                           {{image("a/0.png", pixels), image("b/0.jpg", pixels)}, {}});
  EXPECT_EQ(test::readFile(path("a/0.png")).substr(1, 3), "PNG");
  EXPECT_EQ(test::readFile(path("b/0.jpg")).substr(0, 2), "\xFF\xD8");
}

TEST_F(DatasetStoreTest, ListsWhatItWrote) {
  auto store = makeStore();
  store->commitScene({7, Stamp{1650000000123456789}, 3, "front", 640, 480, "train", 42},
                     someScene(7));
  const auto image_bytes = std::to_string(fs::file_size(path("a/7.png")));
  EXPECT_THAT(query("SELECT \"index\", instant, stamp_ns, camera, width, height, split, seed, "
                    "state FROM scene"),
              ElementsAre("7|3|1650000000123456789|front|640|480|train|42|written"));
  EXPECT_THAT(query("SELECT path, writer, scene, bytes, linked_to FROM file"),
              UnorderedElementsAre("a/7.png|0|7|" + image_bytes + "|NULL", "a/7.txt|0|7|7|NULL",
                                   "b/x/7.png|1|7|" + image_bytes + "|a/7.png"));
  EXPECT_THAT(query("SELECT * FROM writer"), ElementsAre("0|a|test/A|a/", "1|b|test/B|b/"));
}

TEST_F(DatasetStoreTest, ListsDigestsThatSha256sumAgreesWith) {
  auto store = makeStore();
  store->commitScene({0, Stamp{0}}, {{text("a/0.txt", "abc")}, {}});
  store->writeDatasetFile(0, path("list.txt"), [](std::ostream& list) { list << "abc"; });
  // The example of FIPS 180-4.
  const std::string abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
  EXPECT_THAT(query("SELECT digest FROM file"), ElementsAre(abc, abc));
}

TEST_F(DatasetStoreTest, ListsWhatWasMeasuredAndNothingElse) {
  auto store = makeStore();
  SceneFacts facts{0, Stamp{0}};
  ObjectFacts seen;
  seen.X_GO = Pose(Eigen::Translation3d(1.0, 2.0, 3.0));
  seen.loose_box = Box{-10.5, -0.5, 8.5, 20.5};
  seen.visible_box = Box{0.5, 1.5, 10.5, 20.5};
  seen.visible_pixels = 12;
  seen.visibility = 0.25;
  facts.objects = {seen, ObjectFacts{}};
  facts.contacts = {{"alpha", "wall", 0.02}};
  facts.draws = {{"lights/sun/intensity", "1.5"}, {"floor", R"("dark oak")"}};
  facts.warnings = {{"it rains", "a lot"}};
  store->commitScene(facts, {{}, {}});
  EXPECT_THAT(query("SELECT object, x, y, z, qw, in_view, visible_left, visible_bottom, "
                    "visible_pixels, visibility, truncation, loose_left FROM scene_object"),
              ElementsAre("0|1.0|2.0|3.0|1.0|1|0.5|20.5|12|0.25|NULL|-10.5",
                          "1|0.0|0.0|0.0|1.0|0|NULL|NULL|NULL|NULL|NULL|NULL"));
  EXPECT_THAT(query("SELECT first, second, depth FROM contact"), ElementsAre("alpha|wall|0.02"));
  EXPECT_THAT(query("SELECT * FROM draw ORDER BY name"),
              ElementsAre(R"(0|floor|"dark oak")", "0|lights/sun/intensity|1.5"));
  EXPECT_THAT(query("SELECT * FROM warning"), ElementsAre("0|0|1|it rains|a lot"));
}

TEST_F(DatasetStoreTest, ListsAnObjectThatIsNotInTheSceneWithoutAPose) {
  auto store = makeStore();
  SceneFacts facts{0, Stamp{0}};
  ObjectFacts absent;
  absent.X_GO.reset();
  absent.distance.reset();
  absent.dropped = true;
  facts.objects = {absent};
  store->commitScene(facts, {{}, {}});
  EXPECT_THAT(query("SELECT x, y, z, qx, qy, qz, qw, distance, dropped FROM scene_object"),
              ElementsAre("NULL|NULL|NULL|NULL|NULL|NULL|NULL|NULL|1"));
}

TEST_F(DatasetStoreTest, StopsWhenItsManifestIsGone) {
  auto store = makeStore();
  store->commitScene({0, Stamp{0}}, someScene(0));
  fs::remove(path("manifest.sqlite"));
  EXPECT_THAT(failureOf(*store, 1, someScene(1)),
              AllOf(HasSubstr(path("manifest.sqlite")), HasSubstr("has been removed or replaced")));
  EXPECT_FALSE(fs::exists(path("a/1.txt")));
}

TEST_F(DatasetStoreTest, TellsACompleteRunFromARunningOne) {
  auto store = makeStore();
  EXPECT_THAT(query("SELECT value FROM run WHERE key = 'state'"), ElementsAre("running"));
  store->complete();
  EXPECT_THAT(query("SELECT value FROM run WHERE key = 'state'"), ElementsAre("complete"));
}

TEST_F(DatasetStoreTest, CountsScenesFilesAndBytes) {
  auto store = makeStore();
  store->commitScene({0, Stamp{0}}, {{text("a/0.txt", "12345"), text("b/0.txt", "123")}, {}});
  store->commitScene({1, Stamp{1}}, {{text("a/1.txt", "1")}, {}});
  EXPECT_EQ(store->counts().scenes, 2);
  EXPECT_EQ(store->counts().files, 3);
  EXPECT_EQ(store->counts().bytes, 9);
}

TEST_F(DatasetStoreTest, LeavesNothingOfASceneThatFails) {
  auto store = makeStore();
  fs::create_directories(path("b/x/0.png"));  // a folder where the scene's last file should go
  const std::string failure = failureOf(*store, 0, someScene(0));
  EXPECT_THAT(failure, AllOf(HasSubstr("scene 0: cannot write '" + path("b/x/0.png") + "'"),
                             HasSubstr("Is a directory")));
  EXPECT_THAT(tree(), ElementsAre("a", "b", "b/x", "b/x/0.png"));
  EXPECT_THAT(query("SELECT path FROM file"), IsEmpty());
  EXPECT_THAT(query("SELECT * FROM scene"), IsEmpty());
  EXPECT_EQ(store->counts().scenes, 0);
  EXPECT_EQ(store->counts().files, 0);
}

TEST_F(DatasetStoreTest, KeepsEarlierScenesWhenOneFails) {
  auto store = makeStore();
  store->commitScene({0, Stamp{0}}, someScene(0));
  fs::create_directories(path("b/x/1.png"));
  EXPECT_NE(failureOf(*store, 1, someScene(1)), "no error");
  fs::remove(path("b/x/1.png"));
  store->commitScene({1, Stamp{1}}, someScene(1));
  EXPECT_EQ(test::readFile(path("a/0.txt")), "label 0");
  EXPECT_THAT(query("SELECT \"index\" FROM scene"), ElementsAre("0", "1"));
}

TEST_F(DatasetStoreTest, RefusesAFileNameThatAnEarlierSceneHas) {
  auto store = makeStore();
  store->commitScene({3, Stamp{0}}, {{text("a/label.txt", "3")}, {}});
  EXPECT_THAT(failureOf(*store, 4, {{text("a/label.txt", "4")}, {}}),
              AllOf(HasSubstr("scene 4: '" + path("a/label.txt") + "'"),
                    HasSubstr("scene 3 of writer 'a'")));
  EXPECT_EQ(test::readFile(path("a/label.txt")), "3");
}

TEST_F(DatasetStoreTest, RefusesTheSameSceneTwice) {
  auto store = makeStore();
  store->commitScene({0, Stamp{0}}, {{}, {}});
  EXPECT_THAT(failureOf(*store, 0, {{}, {}}), HasSubstr("scene 0: it is in the dataset already"));
}

TEST_F(DatasetStoreTest, RefusesTwoDrawsOfOneEntry) {
  auto store = makeStore();
  SceneFacts facts{0, Stamp{0}};
  facts.draws = {{"floor", "1"}, {"floor", "2"}};
  EXPECT_THROW(store->commitScene(facts, {{}, {}}), Error);
  EXPECT_THAT(query("SELECT * FROM draw"), IsEmpty());
}

TEST_F(DatasetStoreTest, NamesAnImageThatCannotBeEncoded) {
  auto store = makeStore();
  const cv::Mat depth(4, 4, CV_32FC1, cv::Scalar(1.0));
  EXPECT_THAT(failureOf(*store, 0, {{image("a/0.png", depth)}, {}}),
              AllOf(HasSubstr(path("a/0.png")), HasSubstr("CV_32FC1")));
}

TEST_F(DatasetStoreTest, HandsRecordsBackInSceneOrder) {
  auto store = makeStore();
  for (const int index : {2, 0, 1}) store->commitScene({index, Stamp{index}}, someScene(index));
  std::vector<std::string> seen;
  store->records(0)->forEach("all", [&](std::int64_t scene, const std::string& record) {
    seen.push_back(std::to_string(scene) + " " + record);
  });
  EXPECT_THAT(seen, ElementsAre("0 record 0", "0 second", "1 record 1", "1 second", "2 record 2",
                                "2 second"));
}

TEST_F(DatasetStoreTest, HandsRecordsBackByteForByteAndTwice) {
  auto store = makeStore();
  const std::string record("a\0b\n\xC3\xA4", 6);
  store->commitScene({0, Stamp{0}}, {{}, {{1, "all", record}, {1, "al", "l\nx"}, {1, "all", ""}}});
  const auto records = store->records(1);
  for (int time = 0; time < 2; ++time) {
    std::vector<std::string> seen;
    records->forEach("all", [&](std::int64_t, const std::string& text) { seen.push_back(text); });
    EXPECT_THAT(seen, ElementsAre(record, ""));
  }
}

TEST_F(DatasetStoreTest, KeepsNoRecordsOfASceneThatFails) {
  auto store = makeStore();
  fs::create_directories(path("b/x/0.png"));
  EXPECT_NE(failureOf(*store, 0, someScene(0)), "no error");
  store->records(0)->forEach("all", [](std::int64_t, const std::string&) { ADD_FAILURE(); });
}

TEST_F(DatasetStoreTest, StreamsADatasetFileWhileRecordsAreRead) {
  auto store = makeStore();
  for (int index = 0; index < 3; ++index) store->commitScene({index, Stamp{0}}, someScene(index));
  const auto records = store->records(0);
  store->writeDatasetFile(0, path("list.txt"), [&](std::ostream& list) {
    records->forEach("all", [&](std::int64_t, const std::string& text) { list << text << "\n"; });
  });
  EXPECT_EQ(test::readFile(path("list.txt")),
            "record 0\nsecond\nrecord 1\nsecond\nrecord 2\nsecond\n");
  EXPECT_THAT(query("SELECT path, writer, bytes, linked_to FROM file WHERE scene IS NULL"),
              ElementsAre("list.txt|0|48|NULL"));
}

TEST_F(DatasetStoreTest, LeavesNothingOfADatasetFileThatFails) {
  auto store = makeStore();
  const auto content = [](std::ostream& list) {
    list << "half";
    throw Error("no more");
  };
  EXPECT_THROW(store->writeDatasetFile(0, path("list.txt"), content), Error);
  EXPECT_THAT(tree(), ElementsAre("a", "b"));
  EXPECT_THAT(query("SELECT path FROM file"), IsEmpty());
}

TEST_F(DatasetStoreTest, ProtectsItsManifestFromWriters) {
  auto store = makeStore();
  EXPECT_THAT(failureOf(*store, 0, {{text("manifest.sqlite", "")}, {}}),
              HasSubstr("is the dataset's manifest"));
  EXPECT_THAT(failureOf(*store, 0, {{text("manifest.sqlite-wal", "")}, {}}),
              HasSubstr("is the dataset's manifest"));
}

/// One run's manifest, byte for byte.
std::string manifestOfARun(const std::string& folder) {
  StoreOptions options;
  options.folder = folder;
  DatasetStore store(options, {{"a", "test/A", folder + "/a/", {}}});
  for (int index = 0; index < 40; ++index) {
    const std::string file = folder + "/a/" + std::to_string(index);
    store.commitScene({index, Stamp{index * 1000}},
                      {{{0, file + ".png", picture(index), ""}, {0, file + ".txt", {}, "x"}},
                       {{0, "all", "record of scene " + std::to_string(index)}}});
  }
  store.writeDatasetFile(0, folder + "/a/list", [](std::ostream& list) { list << "all"; });
  store.complete();
  return test::readFile(store.manifestPath());
}

TEST(DatasetStore, MakesEqualManifestsInEqualRuns) {
  const test::TemporaryFolder first;
  const test::TemporaryFolder second;
  EXPECT_EQ(manifestOfARun(first.path().string()), manifestOfARun((second / "deeper").string()));
}

/// SQLite's log is removed at the end of the run, which takes a moment without readers.
TEST(DatasetStore, EndsWhileOthersReadItsManifest) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "manifest.sqlite").string();
  std::atomic<bool> is_over{false};
  std::thread reader([&] {
    while (!is_over) {
      if (!fs::exists(file)) continue;
      try {
        const base::SqliteDatabase manifest(file, base::SqliteDatabase::Mode::kReadOnly);
        base::SqliteStatement count(manifest, "SELECT count(*) FROM scene");
        while (count.step()) continue;
      } catch (const Error&) {
        continue;  // the file was there, but its tables were not yet
      }
    }
  });
  EXPECT_NO_THROW(static_cast<void>(manifestOfARun(folder.path().string())));
  is_over = true;
  reader.join();
}

TEST(DatasetStore, LeavesASingleManifestFile) {
  const test::TemporaryFolder folder;
  EXPECT_NE(manifestOfARun(folder.path().string()), "");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, UnorderedElementsAre("a", "manifest.sqlite"));
}

}  // namespace dataset_store_test
}  // namespace synthetic_dataset::output

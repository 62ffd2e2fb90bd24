#include "output/written_dataset.h"

#include <ostream>

#include <gmock/gmock.h>

#include "output/store_fixture.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace written_dataset_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class WrittenDatasetTest : public StoreFixture {
 protected:
  /// Commits a scene with one file of writer `a`.
  void addScene(std::int64_t index, const std::string& camera = "camera",
                std::int64_t instant = 0) {
    store_->commitScene({index, Stamp{index}, instant, camera},
                        {{text("a/" + std::to_string(index) + ".txt", "x")}, {}});
  }

  [[nodiscard]] WrittenDataset dataset() const { return WrittenDataset(folder_.path()); }

  [[nodiscard]] StoreOptions overwriting() const {
    StoreOptions chosen = options();
    chosen.if_exists = IfExists::kOverwrite;
    return chosen;
  }

  std::unique_ptr<DatasetStore> store_ = makeStore();
};

TEST_F(WrittenDatasetTest, ListsWritersInTheirOrder) {
  const WrittenDataset written = dataset();
  ASSERT_EQ(written.writers().size(), 2U);
  EXPECT_EQ(written.writers()[0].name, "a");
  EXPECT_EQ(written.writers()[1].name, "b");
  EXPECT_EQ(written.writers()[1].type, "test/B");
  EXPECT_EQ(written.writers()[1].folder, path("b/"));
}

TEST_F(WrittenDatasetTest, NamesScenesAsTheRunDid) {
  for (const int index : {0, 1, 2}) addScene(index, "camera", index);
  const WrittenSceneRow row = dataset().scene(2);
  EXPECT_EQ(row.name, "00000002");
  EXPECT_EQ(row.camera_index, 0U);
}

TEST_F(WrittenDatasetTest, NamesScenesOfSeveralCamerasByCameraAndInstant) {
  RunDescription run;
  run.cameras = {{"front", "front_optical", 64, 48}, {"rear", "rear_optical", 64, 48}};
  store_.reset();
  store_ = std::make_unique<DatasetStore>(overwriting(), writers(), run);
  addScene(0, "front", 0);
  addScene(1, "rear", 0);
  addScene(2, "front", 1);
  addScene(3, "rear", 1);
  const WrittenSceneRow row = dataset().scene(3);
  EXPECT_EQ(row.name, "rear/00000001");
  EXPECT_EQ(row.camera_index, 1U);
}

TEST_F(WrittenDatasetTest, FindsTheSceneInTheMiddle) {
  for (const int index : {0, 4, 9}) addScene(index);
  EXPECT_EQ(dataset().middleScene(), 4);
}

TEST_F(WrittenDatasetTest, ListsItsScenes) {
  for (const int index : {9, 0, 4}) addScene(index);
  EXPECT_THAT(dataset().scenes(), ElementsAre(0, 4, 9));
}

TEST_F(WrittenDatasetTest, CountsItsScenesAndBytes) {
  for (const int index : {0, 1, 2}) addScene(index);
  const WrittenCounts counts = dataset().counts();
  EXPECT_EQ(counts.scenes, 3);
  EXPECT_EQ(counts.bytes, 3);  // a letter each
  EXPECT_THAT(counts.labels, IsEmpty());
}

TEST_F(WrittenDatasetTest, KnowsWhoMakesPictures) {
  store_->commitScene({0, Stamp{0}}, {{text("a/0.txt", ""), text("b/0.png", "")}, {}});
  const WrittenDataset written = dataset();
  EXPECT_FALSE(written.hasPictures(written.writers()[0]));
  EXPECT_TRUE(written.hasPictures(written.writers()[1]));
}

TEST_F(WrittenDatasetTest, KnowsTheFoldersOfItsWriters) {
  const WrittenDataset written = dataset();
  EXPECT_TRUE(written.isInAWriter(path("a")));
  EXPECT_TRUE(written.isInAWriter(path("b/new")));
  EXPECT_FALSE(written.isInAWriter(path("drawn")));
  EXPECT_FALSE(written.isInAWriter(folder_.path()));
}

TEST_F(WrittenDatasetTest, TellsThatItHasNoScenes) {
  const WrittenDataset written = dataset();
  EXPECT_THROW((void)written.middleScene(), Error);
}

TEST_F(WrittenDatasetTest, TellsWhichScenesThereAre) {
  addScene(0);
  addScene(1);
  try {
    (void)dataset().scene(7);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("found the scene 7; the dataset has 0 to 1"));
  }
}

TEST_F(WrittenDatasetTest, ListsFilesByWriterAndScene) {
  store_->commitScene({0, Stamp{0}},
                      {{text("a/z.txt", ""), text("a/b.txt", ""), text("b/0.txt", "")}, {}});
  addScene(1);
  store_->writeDatasetFile(0, path("a/all"), [](std::ostream& /*stream*/) {});
  const WrittenDataset written = dataset();
  EXPECT_THAT(written.files(written.writers()[0], 0),
              ElementsAre(path("a/b.txt"), path("a/z.txt")));
  EXPECT_THAT(written.files(written.writers()[1], 0), ElementsAre(path("b/0.txt")));
  EXPECT_THAT(written.files(written.writers()[1], 1), IsEmpty());
}

TEST(WrittenDataset, IsNotMadeWhereThereIsNone) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(WrittenDataset{folder.path()}, Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace written_dataset_test
}  // namespace synthetic_dataset::output

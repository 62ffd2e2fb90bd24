#include "programs/gallery/model_gallery.h"

#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"
#include "world/files/model_folders.h"

namespace synthetic_dataset::programs {
namespace model_gallery_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const cv::Size kCell(256, 192);

std::string modelFile(const std::string& visual) {
  return "<sdf version='1.6'><model name='m'><link name='body'>" + visual + "</link></model></sdf>";
}

const char* const kBox =
    "<visual name='v'><geometry><box><size>1 2 3</size></box></geometry></visual>";

/// Models in their own files, with no ROS package to be found.
class ModelGallery : public ::testing::Test {
 protected:
  void writeModel(const std::string& name, const std::string& content) const {
    folder.write(name + "/model.config",
                 "<model><name>m</name><sdf version='1.6'>model.sdf</sdf></model>");
    folder.write(name + "/model.sdf", content);
  }

  [[nodiscard]] GalleryEntry portrait(const std::string& name) const {
    const std::filesystem::path root(folder.path());
    const auto models = world::findModels(root);
    const world::ResourceFinder finder(
        modelFolders(root, models),
        [](const std::string&) -> std::optional<std::string> { return std::nullopt; });
    return portrayModel(root / name, name, finder, kCell);
  }

  const test::TemporaryFolder folder;
};

TEST_F(ModelGallery, TakesAPictureOfAModel) {
  writeModel("box", modelFile(kBox));
  const GalleryEntry entry = portrait("box");
  EXPECT_THAT(entry.error, IsEmpty());
  EXPECT_EQ(entry.picture.size(), kCell);
  EXPECT_EQ(entry.counts.triangles, 12U);
}

TEST_F(ModelGallery, ModelsFindEachOtherByTheirFoldersNames) {
  writeModel("deep/box", modelFile(kBox));
  writeModel("pair",
             "<sdf version='1.6'><model name='pair'><include><uri>model://box</uri></include>"
             "</model></sdf>");
  const GalleryEntry entry = portrait("pair");
  EXPECT_THAT(entry.error, IsEmpty());
  EXPECT_EQ(entry.counts.visuals, 1U);
}

TEST_F(ModelGallery, KeepsTheReasonWhyAModelCannotBeLoaded) {
  writeModel("broken", "<sdf version='1.6'><model name='broken'>");
  const GalleryEntry entry = portrait("broken");
  EXPECT_THAT(entry.error, HasSubstr("model.sdf"));
  EXPECT_TRUE(entry.picture.empty());
  EXPECT_THAT(galleryTable({entry}), HasSubstr("broken  cannot be loaded: "));
}

TEST_F(ModelGallery, ShowsAModelWithoutWhatIsMissing) {
  writeModel("poor", modelFile("<visual name='w'><geometry><mesh><uri>gone.dae</uri></mesh>"
                               "</geometry></visual>" +
                               std::string(kBox)));
  const GalleryEntry entry = portrait("poor");
  EXPECT_THAT(entry.error, IsEmpty());
  EXPECT_FALSE(entry.picture.empty());
  EXPECT_THAT(entry.notes, testing::ElementsAre(HasSubstr("gone.dae")));
}

TEST_F(ModelGallery, ShowsAWorldAndEachOfItsModelsWithWhatTheyLack) {
  const std::string link = "<link name='body'>" + std::string(kBox) + "</link>";
  const std::string poor =
      "<link name='body'><visual name='w'><geometry><mesh><uri>gone.dae</uri></mesh></geometry>"
      "</visual></link>";
  folder.write("shop.world", "<sdf version='1.6'><world name='shop'><model name='box'>" + link +
                                 "</model><model name='cart'>" + poor + "</model></world></sdf>");
  const world::ResourceFinder finder({}, nullptr);
  const std::vector<GalleryEntry> entries = portrayWorld(folder / "shop.world", finder, kCell);
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].name, "shop.world");
  EXPECT_EQ(entries[0].counts.links, 2U);
  EXPECT_EQ(entries[1].name, "box");
  EXPECT_THAT(entries[1].notes, IsEmpty());
  EXPECT_EQ(entries[2].name, "cart");
  EXPECT_TRUE(entries[2].picture.empty());
  EXPECT_THAT(entries[2].notes, ElementsAre(HasSubstr("gone.dae")));
}

TEST_F(ModelGallery, SaysWhyAWorldCannotBeLoaded) {
  folder.write("torn.world", "<sdf version='1.6'><world name='torn'>");
  const world::ResourceFinder finder({}, nullptr);
  const std::vector<GalleryEntry> entries = portrayWorld(folder / "torn.world", finder, kCell);
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_THAT(entries[0].error, HasSubstr("torn.world"));
}

TEST_F(ModelGallery, TheTableHasALineForEachModelAndItsRemarks) {
  GalleryEntry entry;
  entry.name = "shelf";
  entry.counts.links = 3;
  entry.notes = {"left out a sensor"};
  const std::string table = galleryTable({entry});
  EXPECT_THAT(table, HasSubstr("shelf          3"));
  EXPECT_THAT(table, HasSubstr("shelf: left out a sensor\n"));
}

TEST_F(ModelGallery, TheSheetHoldsAllPicturesAndErrors) {
  GalleryEntry seen;
  seen.picture = cv::Mat(kCell, CV_8UC3, cv::Scalar(1, 2, 3));
  GalleryEntry broken;
  broken.error = "mesh 'x.dae': no such file";
  const cv::Mat sheet = contactSheet({seen, seen, broken}, kCell);
  EXPECT_EQ(sheet.cols, 2 * kCell.width);
  EXPECT_EQ(sheet.at<cv::Vec3b>(100, 300), cv::Vec3b(1, 2, 3));
  cv::Mat error = sheet(cv::Rect(0, sheet.rows / 2, kCell.width, kCell.height));
  double darkest = 255.0;
  cv::minMaxLoc(error.reshape(1), &darkest);
  EXPECT_LT(darkest, 100.0) << "something is written";
}

}  // namespace model_gallery_test
}  // namespace synthetic_dataset::programs

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace dataset_info_test {

using testing::ElementsAre;

CameraDescription camera(const std::string& name) {
  return {name, name + "_link", CameraModel(4, 4, {1, 1, 2, 2}, 0.1, 10)};
}

TEST(DatasetInfo, HasOneSplitFolderWithoutSplits) {
  DatasetInfo dataset;
  EXPECT_THAT(dataset.splitFolders(), ElementsAre("train"));
  dataset.splits = {{"val", 3}, {"test", 4}};
  EXPECT_THAT(dataset.splitFolders(), ElementsAre("val", "test"));
}

TEST(DatasetInfo, NumbersClassesWithoutGaps) {
  DatasetInfo dataset;
  dataset.classes = {{1, "cup"}, {3, "jug"}};
  EXPECT_EQ(dataset.classIndex(3), 1U);
  EXPECT_THROW((void)dataset.classIndex(2), Error);
  EXPECT_THAT(dataset.classNamesWithoutGaps(), ElementsAre("unused_0", "cup", "unused_2", "jug"));
}

TEST(DatasetInfo, GivesCamerasFoldersWhereThereAreSeveral) {
  DatasetInfo dataset;
  dataset.cameras = {camera("front")};
  EXPECT_EQ(dataset.cameraFolder(0), "");
  dataset.cameras.push_back(camera("rear"));
  EXPECT_EQ(dataset.cameraFolder(1), "rear/");
}

TEST(DatasetInfo, RefusesWhatAFormatHasNoRoomFor) {
  DatasetInfo dataset;
  dataset.cameras = {camera("front")};
  dataset.objects.emplace_back();
  EXPECT_NO_THROW(dataset.refuseVaryingIntrinsics("camera.txt"));
  EXPECT_NO_THROW(dataset.refuseVaryingModels("model.ply"));
  dataset.cameras[0].intrinsics_vary = true;
  dataset.objects[0].model_varies = true;
  EXPECT_THROW(dataset.refuseVaryingIntrinsics("camera.txt"), Error);
  EXPECT_THROW(dataset.refuseVaryingModels("model.ply"), Error);
}

TEST(DatasetInfo, MakesModelsWhereItKnowsHow) {
  DatasetInfo dataset;
  EXPECT_THROW((void)dataset.model(0), Error);
  dataset.setModels([](std::size_t object) {
    ObjectModel model;
    model.diameter = static_cast<double>(object);
    return model;
  });
  EXPECT_EQ(dataset.model(3).diameter, 3.0);
}

}  // namespace dataset_info_test
}  // namespace synthetic_dataset

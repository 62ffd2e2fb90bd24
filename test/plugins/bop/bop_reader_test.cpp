#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "support/error_messages.h"

namespace synthetic_dataset::formats {
namespace bop_reader_test {

using testing::HasSubstr;

class BopReader : public ReaderTest {
 protected:
  BopReader() : ReaderTest("Bop") {}
};

TEST_F(BopReader, ReadsMasksBoxesAndModels) {
  const auto file = image("train/000003/rgb/000012.png");
  picture("train/000003/mask_visib/000012_000000.png", cv::Mat(80, 100, CV_8UC1, cv::Scalar(255)));
  folder_.write("train/000003/scene_camera.json",
                R"({"12": {"cam_K": [100, 0, 50, 0, 100, 40, 0, 0, 1]}})");
  folder_.write("train/000003/scene_gt.json",
                R"({"12": [{"obj_id": 7, "cam_R_m2c": [1, 0, 0, 0, 1, 0, 0, 0, 1],
                            "cam_t_m2c": [0, 0, 7500]}]})");
  folder_.write("train/000003/scene_gt_info.json", R"({"12": [{"bbox_obj": [10, 20, 4, 5]}]})");
  folder_.write("models/models_info.json",
                R"({"7": {"min_x": -1000, "min_y": -1000, "min_z": -2500, "size_x": 2000,
                          "size_y": 2000, "size_z": 5000}})");
  const LabelledPicture read = readScene({file});
  ASSERT_EQ(read.labels.size(), 1U);
  EXPECT_EQ(read.labels[0].box->left, 9.5);
  EXPECT_EQ(read.labels[0].box->right, 14.5);
  EXPECT_EQ(cv::countNonZero(read.labels[0].mask), 8000);
  EXPECT_TRUE(hasLine(read.labels[0], {30.0, 20.0}, {70.0, 20.0}));  // 5 m away
}

TEST_F(BopReader, NamesAFileThatLacksTheImage) {
  const auto file = image("train/000003/rgb/000012.png");
  folder_.write("train/000003/scene_camera.json", "{}");
  EXPECT_THAT(test::messagesOf([&] { (void)readScene({file}); }),
              testing::ElementsAre(HasSubstr("scene_camera.json'")));
}

}  // namespace bop_reader_test
}  // namespace synthetic_dataset::formats

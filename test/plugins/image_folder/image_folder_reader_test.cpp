#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace image_folder_reader_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class ImageFolderReader : public ReaderTest {
 protected:
  ImageFolderReader() : ReaderTest("ImageFolder") {}

  /// The labels read for val/front/0.png, 8 x 4 pixels.
  [[nodiscard]] LabelledPicture read(const std::string& metadata) const {
    (void)folder_.write("val/metadata.jsonl", metadata);
    cv::Mat1w instances(4, 8, std::uint16_t{0});
    instances(cv::Rect(1, 1, 3, 2)) = 700;
    return readScene({picture("val/front/0.mask.png", instances), image("val/front/0.png", {8, 4})},
                     "front/0");
  }
};

const std::string kMetadata = R"({"file_name": "front/1.png"}
{"file_name": "front/0.png", "mask_file_name": "front/0.mask.png", "width": 8, "height": 4, )"
                              R"("camera": {"name": "front", "K": [5, 0, 3, 0, 5, 2, 0, 0, 1], )"
                              R"("distortion_model": "none", "D": [0, 0, 0, 0, 0, 0, 0, 0]}, )"
                              R"("objects": {"bbox": [[1.0, 1.0, 3.0, 2.0]], )"
                              R"("class_names": ["fork lift"], "instances": [700], )"
                              R"("X_CO": [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 6, 0, 0, 0, 1]], )"
                              R"("cuboid": [[-1, -1, -1, 1, 1, 1]], )"
                              R"("keypoints": [[[1.5, 2.0], [3.0, 1.0], [-4.0, 0.0]]], )"
                              R"("keypoint_visibility": [[2, 1, 0]]}}
)";

TEST_F(ImageFolderReader, ReadsTheImagesLine) {
  const LabelledPicture picture = read(kMetadata);
  ASSERT_EQ(picture.image.cols, 8);
  ASSERT_EQ(picture.labels.size(), 1U);
  const DrawnLabel& label = picture.labels.front();
  EXPECT_EQ(label.caption, "fork lift");
  EXPECT_DOUBLE_EQ(label.box->left, 0.5);
  EXPECT_DOUBLE_EQ(label.box->bottom, 2.5);
  EXPECT_EQ(cv::countNonZero(label.mask), 6);
  EXPECT_THAT(label.keypoints, ElementsAre(cv::Point2d(1.5, 2.0)));
  EXPECT_THAT(label.hidden_keypoints, ElementsAre(cv::Point2d(3.0, 1.0)));
}

TEST_F(ImageFolderReader, DrawsCuboidsThroughTheCamera) {
  const auto lines = read(kMetadata).labels.front().lines;
  ASSERT_THAT(lines, SizeIs(12 * 16));
  // Corner (-1, -1, -1) is at z = 5 m, where a metre is a pixel.
  EXPECT_NEAR(lines.front()[0].x, 2.0, 1e-12);
  EXPECT_NEAR(lines.front()[0].y, 1.0, 1e-12);
}

TEST_F(ImageFolderReader, NamesTheFileWithoutALineOfTheImage) {
  try {
    (void)read(R"({"file_name": "front/1.png"})");
    FAIL() << "no line";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("val/metadata.jsonl': no line of 'front/0.png'"));
  }
}

}  // namespace image_folder_reader_test
}  // namespace synthetic_dataset::formats

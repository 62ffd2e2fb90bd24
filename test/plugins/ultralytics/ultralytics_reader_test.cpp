#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace ultralytics_reader_test {

using testing::ElementsAre;

class UltralyticsReader : public ReaderTest {
 protected:
  UltralyticsReader() : ReaderTest("UltralyticsYolo") {}

  /// The first label of a picture of 200 x 100 with this label file.
  [[nodiscard]] DrawnLabel read(const std::string& text) const {
    const LabelledPicture picture = readScene(
        {image("images/train/0.png", {200, 100}), folder_.write("labels/train/0.txt", text)});
    EXPECT_EQ(picture.image.cols, 200);
    return picture.labels.empty() ? DrawnLabel() : picture.labels.front();
  }
};

TEST_F(UltralyticsReader, ReadsBoxesAndNames) {
  (void)folder_.write("data.yaml", "train: images/train\nnames:\n  0: \"fork \\\"lift\\\"\"\n");
  const DrawnLabel label = read("0 0.5 0.5 0.25 0.5\n");
  EXPECT_EQ(label.caption, "fork \"lift\"");
  // Centre (100, 50) and size 50 x 50 with pixel edges at whole numbers; here, half a pixel less.
  EXPECT_DOUBLE_EQ(label.box->left, 74.5);
  EXPECT_DOUBLE_EQ(label.box->top, 24.5);
  EXPECT_DOUBLE_EQ(label.box->right, 124.5);
  EXPECT_DOUBLE_EQ(label.box->bottom, 74.5);
}

TEST_F(UltralyticsReader, ReadsPolygons) {
  (void)folder_.write("data.yaml", "names:\n");
  const DrawnLabel label = read("3 0.0 0.0 0.5 0.0 0.5 0.5 0.25 0.5 0.0 0.5\n");
  EXPECT_EQ(label.caption, "3");
  EXPECT_FALSE(label.box.has_value());
  EXPECT_THAT(label.polygons.front(),
              ElementsAre(cv::Point2d(-0.5, -0.5), cv::Point2d(99.5, -0.5), cv::Point2d(99.5, 49.5),
                          cv::Point2d(49.5, 49.5), cv::Point2d(-0.5, 49.5)));
}

TEST_F(UltralyticsReader, ReadsKeypointsWhereTheDatasetHasThem) {
  (void)folder_.write("data.yaml", "names:\n  0: \"a\"\nkpt_shape: [3, 3]\n");
  const DrawnLabel label = read("0 0.5 0.5 0.25 0.5 0.5 0.25 2 0.25 0.5 1 0 0 0\n");
  EXPECT_TRUE(label.box.has_value());
  EXPECT_THAT(label.keypoints, ElementsAre(cv::Point2d(99.5, 24.5)));
  EXPECT_THAT(label.hidden_keypoints, ElementsAre(cv::Point2d(49.5, 49.5)));
}

TEST_F(UltralyticsReader, ReadsAnEmptyFile) {
  (void)folder_.write("data.yaml", "names:\n");
  EXPECT_FALSE(read("").box.has_value());
}

TEST_F(UltralyticsReader, DoesNotGuessWithoutTheDatasetsFile) {
  EXPECT_THROW((void)read("0 0.5 0.5 0.25 0.5\n"), Error);
}

TEST_F(UltralyticsReader, RefusesLinesThatAreNoLabels) {
  (void)folder_.write("data.yaml", "names:\n");
  EXPECT_THROW((void)read("0 0.5 0.5\n"), Error);
  EXPECT_THROW((void)read("0 0.5 0.5 0.5 0.5 0.5\n"), Error);
  EXPECT_THROW((void)read("0 0.5 0.5 0.5 nothing\n"), Error);
}

}  // namespace ultralytics_reader_test
}  // namespace synthetic_dataset::formats

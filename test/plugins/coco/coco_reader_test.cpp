#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace coco_reader_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CocoReader : public ReaderTest {
 protected:
  CocoReader() : ReaderTest("Coco") {}

  /// The labels read for images/val/front/0.png, 5 x 4 pixels, with this list of annotations.
  [[nodiscard]] LabelledPicture read(const std::string& annotations) const {
    const std::string train = R"({"images": [{"id": 7, "file_name": "front/9.png"}],
      "annotations": [], "categories": []})";
    const std::string val = R"({"images": [{"id": 8, "file_name": "front/0.png"}],
      "annotations": [)" + annotations +
                            R"(], "categories": [{"id": 3, "name": "fork lift",
      "keypoints": ["a", "b", "c"], "skeleton": [[1, 2], [2, 3]]}]})";
    (void)folder_.write("annotations/instances_train.json", train);
    (void)folder_.write("annotations/instances_val.json", val);
    return readScene({image("images/val/front/0.png", {5, 4})});
  }
};

TEST_F(CocoReader, ReadsBoxesAndMasks) {
  const LabelledPicture picture = read(R"({"id": 1, "image_id": 8, "category_id": 3,
    "bbox": [1.0, 1.0, 3.0, 2.0], "segmentation": {"size": [4, 5], "counts": "5220003"}})");
  ASSERT_EQ(picture.labels.size(), 1U);
  const DrawnLabel& label = picture.labels.front();
  EXPECT_EQ(label.caption, "fork lift");
  EXPECT_DOUBLE_EQ(label.box->left, 0.5);
  EXPECT_DOUBLE_EQ(label.box->bottom, 2.5);
  EXPECT_EQ(cv::countNonZero(label.mask), 6);
}

TEST_F(CocoReader, ReadsPolygons) {
  const LabelledPicture picture = read(R"({"id": 1, "image_id": 8, "category_id": 3,
    "bbox": [1.0, 1.0, 3.0, 2.0], "segmentation": [[1, 1, 4, 1, 4, 3]]})");
  EXPECT_THAT(picture.labels.front().polygons,
              ElementsAre(ElementsAre(cv::Point2d(0.5, 0.5), cv::Point2d(3.5, 0.5),
                                      cv::Point2d(3.5, 2.5))));
}

TEST_F(CocoReader, ReadsKeypointsAndTheLinesBetweenThoseInTheImage) {
  const LabelledPicture picture = read(R"({"id": 1, "image_id": 8, "category_id": 3,
    "bbox": [1.0, 1.0, 3.0, 2.0], "segmentation": [],
    "keypoints": [1.5, 2.0, 2, 3.0, 2.0, 1, 0.0, 0.0, 0], "num_keypoints": 2})");
  const DrawnLabel& label = picture.labels.front();
  EXPECT_THAT(label.keypoints, ElementsAre(cv::Point2d(1.5, 2.0)));
  EXPECT_THAT(label.hidden_keypoints, ElementsAre(cv::Point2d(3.0, 2.0)));
  EXPECT_THAT(label.lines, ElementsAre(ElementsAre(cv::Point2d(1.5, 2.0), cv::Point2d(3.0, 2.0))));
}

TEST_F(CocoReader, LeavesOtherImagesAnnotationsAlone) {
  EXPECT_THAT(read(R"({"id": 1, "image_id": 7, "category_id": 3})").labels, IsEmpty());
}

TEST_F(CocoReader, NamesTheFileThatLacksAKey) {
  try {
    (void)read(R"({"id": 1, "image_id": 8, "category_id": 3, "segmentation": []})");
    FAIL() << "bbox is missing";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("annotations/instances_val.json'"));
  }
}

}  // namespace coco_reader_test
}  // namespace synthetic_dataset::formats

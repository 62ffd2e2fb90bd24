#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace pascal_voc_reader_test {

class PascalVocReader : public ReaderTest {
 protected:
  PascalVocReader() : ReaderTest("PascalVoc") {}

  [[nodiscard]] LabelledPicture read(const std::string& annotation) {
    files_.push_back(folder_.write("Annotations/0.xml", annotation));
    return readScene(files_);
  }

  static constexpr const char* kObject =
      "<object><name>a &lt;b&gt;</name><truncated>0</truncated><occluded>1</occluded>"
      "<difficult>0</difficult><bndbox><xmin>2</xmin><ymin>3</ymin><xmax>4</xmax>"
      "<ymax>5</ymax></bndbox></object>";

  std::vector<std::filesystem::path> files_ = {image("JPEGImages/0.png", {20, 10})};
};

TEST_F(PascalVocReader, ReadsBoxesCountedFromOne) {
  const LabelledPicture picture = read(std::string("<annotation>") + kObject + "</annotation>");
  ASSERT_EQ(picture.labels.size(), 1U);
  const DrawnLabel& label = picture.labels.front();
  EXPECT_EQ(label.caption, "a <b>, occluded");
  // Pixels 1 to 3 and 2 to 4, from edge to edge.
  EXPECT_DOUBLE_EQ(label.box->left, 0.5);
  EXPECT_DOUBLE_EQ(label.box->top, 1.5);
  EXPECT_DOUBLE_EQ(label.box->right, 3.5);
  EXPECT_DOUBLE_EQ(label.box->bottom, 4.5);
}

TEST_F(PascalVocReader, ReadsBoxesCountedFromZeroWhereTheFileSaysSo) {
  const LabelledPicture picture =
      read(std::string("<annotation>pixels are counted from 0</annotation>") + kObject);
  EXPECT_DOUBLE_EQ(picture.labels.front().box->left, 1.5);
}

TEST_F(PascalVocReader, ReadsThePictureOfObjects) {
  cv::Mat objects(10, 20, CV_8UC3, cv::Scalar::all(0));
  objects.at<cv::Vec3b>(0, 0) = {0, 0, 128};
  objects.at<cv::Vec3b>(0, 1) = {192, 224, 224};  // void
  objects.at<cv::Vec3b>(9, 19) = {0, 128, 0};
  files_.push_back(picture("SegmentationObject/0.png", objects));
  const LabelledPicture picture = read("<annotation></annotation>");
  ASSERT_EQ(picture.labels.size(), 2U);
  EXPECT_EQ(cv::countNonZero(picture.labels[0].mask), 1);
  EXPECT_EQ(picture.labels[0].mask.at<uchar>(0, 0), 255);
  EXPECT_EQ(picture.labels[1].mask.at<uchar>(9, 19), 255);
}

TEST_F(PascalVocReader, NamesTheFileThatLacksAnElement) {
  EXPECT_THROW((void)read("<object><name>a</name></object>"), Error);
}

}  // namespace pascal_voc_reader_test
}  // namespace synthetic_dataset::formats

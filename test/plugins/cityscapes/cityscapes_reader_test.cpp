#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace cityscapes_reader_test {

class CityscapesReader : public ReaderTest {
 protected:
  CityscapesReader() : ReaderTest("Cityscapes") {}

  [[nodiscard]] LabelledPicture read(const cv::Mat& instances) const {
    return readScene({picture("gtFine/a_gtFine_instanceIds.png", instances),
                      image("leftImg8bit/a_leftImg8bit.png", {20, 10})});
  }
};

TEST_F(CityscapesReader, ReadsInstancesAndTheirNames) {
  (void)folder_.write("labels.json", R"([{"id": 26, "name": "car"}])");
  cv::Mat instances(10, 20, CV_16UC1, cv::Scalar(7));
  instances.at<ushort>(3, 4) = 26001;
  instances.at<ushort>(3, 5) = 27000;
  const LabelledPicture picture = read(instances);
  ASSERT_EQ(picture.labels.size(), 2U);
  EXPECT_EQ(picture.labels[0].caption, "car 26001");
  EXPECT_EQ(picture.labels[0].mask.at<uchar>(3, 4), 255);
  EXPECT_EQ(cv::countNonZero(picture.labels[0].mask), 1);
  EXPECT_EQ(picture.labels[1].caption, "27000");
}

TEST_F(CityscapesReader, RefusesNumbersThatNoLabelCanHave) {
  for (const char* number : {"7e77", "2.5", "-3000000000", "\"26\""}) {
    (void)folder_.write("labels.json",
                        R"([{"id": )" + std::string(number) + R"(, "name": "car"}])");
    EXPECT_THROW((void)read(cv::Mat(10, 20, CV_16UC1, cv::Scalar(7))), Error) << number;
  }
}

TEST_F(CityscapesReader, RefusesPicturesOfAnotherKind) {
  EXPECT_THROW((void)read(cv::Mat(10, 20, CV_8UC1, cv::Scalar(1))), Error);
}

}  // namespace cityscapes_reader_test
}  // namespace synthetic_dataset::formats

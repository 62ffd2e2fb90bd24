#include "output/image_encoder.h"

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

namespace synthetic_dataset::output {
namespace {

using testing::HasSubstr;
using testing::Optional;

cv::Mat ramp(int type) {
  cv::Mat image(32, 200, type, cv::Scalar::all(0));
  for (int row = 0; row < image.rows; ++row) {
    for (int byte = 0; byte < image.cols * static_cast<int>(image.elemSize()); ++byte) {
      image.ptr(row)[byte] = static_cast<uchar>(row + byte);
    }
  }
  return image;
}

TEST(ImageFormat, FollowsTheExtension) {
  EXPECT_EQ(imageFormat("a/b.png"), ImageFormat::kPng);
  EXPECT_EQ(imageFormat("b.JPG"), ImageFormat::kJpeg);
  EXPECT_EQ(imageFormat("b.jpeg"), ImageFormat::kJpeg);
  EXPECT_EQ(imageFormat("b.txt"), std::nullopt);
  EXPECT_EQ(imageFormat("folder.png/b"), std::nullopt);
}

TEST(ImageEncoder, KeepsEveryPixelTypeInPng) {
  for (const int type : {CV_8UC1, CV_16UC1, CV_8UC3}) {
    const cv::Mat image = ramp(type);
    const cv::Mat read =
        cv::imdecode(encodeImage(image, ImageFormat::kPng, {}), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.type(), type);
    EXPECT_EQ(cv::norm(read, image, cv::NORM_L1), 0.0);
  }
}

TEST(ImageEncoder, MakesTheSameBytesOfTheSamePixels) {
  const cv::Mat image = ramp(CV_8UC3);
  cv::Mat with_gaps(image.rows, image.cols + 7, image.type(), cv::Scalar::all(9));
  image.copyTo(with_gaps.colRange(0, image.cols));
  EXPECT_EQ(encodeImage(image, ImageFormat::kPng, {}),
            encodeImage(with_gaps.colRange(0, image.cols), ImageFormat::kPng, {}));
}

TEST(ImageEncoder, CompressesAsMuchAsAsked) {
  const cv::Mat image = ramp(CV_8UC3);
  EXPECT_GT(encodeImage(image, ImageFormat::kPng, {0, 95}).size(),
            encodeImage(image, ImageFormat::kPng, {9, 95}).size());
  EXPECT_GT(encodeImage(image, ImageFormat::kJpeg, {3, 100}).size(),
            encodeImage(image, ImageFormat::kJpeg, {3, 10}).size());
}

TEST(ImageProblem, NamesWhatWouldBeRight) {
  EXPECT_EQ(imageProblem("a.png", ramp(CV_16UC1)), std::nullopt);
  EXPECT_THAT(imageProblem("a.bmp", ramp(CV_8UC3)), Optional(HasSubstr(".png")));
  EXPECT_THAT(imageProblem("a.png", cv::Mat()), Optional(HasSubstr("no pixels")));
  EXPECT_THAT(imageProblem("a.png", ramp(CV_32FC1)), Optional(HasSubstr("CV_32FC1")));
  EXPECT_THAT(imageProblem("a.jpg", ramp(CV_16UC1)), Optional(HasSubstr("16 bit")));
}

}  // namespace
}  // namespace synthetic_dataset::output

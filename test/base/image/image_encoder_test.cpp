#include "base/image/image_encoder.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

namespace synthetic_dataset::base {
namespace image_encoder_test {

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

/// Floating point numbers of every kind.
cv::Mat floats() {
  using Limits = std::numeric_limits<float>;
  const std::array<float, 10> kinds = {0.0F,
                                       -0.0F,
                                       1.0F / 3.0F,
                                       -12345.678F,
                                       Limits::max(),
                                       Limits::lowest(),
                                       Limits::min(),
                                       Limits::denorm_min(),
                                       Limits::infinity(),
                                       Limits::quiet_NaN()};
  cv::Mat image(30, 50, CV_32FC1);
  for (int i = 0; i < 1500; ++i) {
    image.at<float>(i / 50, i % 50) = kinds[static_cast<std::size_t>(i) % kinds.size()];
  }
  return image;
}

TEST(ImageFormat, FollowsTheExtension) {
  EXPECT_EQ(imageFormat("a/b.png"), ImageFormat::kPng);
  EXPECT_EQ(imageFormat("b.JPG"), ImageFormat::kJpeg);
  EXPECT_EQ(imageFormat("b.jpeg"), ImageFormat::kJpeg);
  EXPECT_EQ(imageFormat("b.tif"), ImageFormat::kTiff);
  EXPECT_EQ(imageFormat("b.TIFF"), ImageFormat::kTiff);
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

TEST(ImageEncoder, KeepsEveryPixelTypeInTiff) {
  for (const int type : {CV_8UC1, CV_16UC1, CV_8UC3}) {
    const cv::Mat image = ramp(type);
    const cv::Mat read =
        cv::imdecode(encodeImage(image, ImageFormat::kTiff, {}), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.type(), type);
    EXPECT_EQ(cv::norm(read, image, cv::NORM_L1), 0.0);
  }
}

TEST(ImageEncoder, KeepsEveryBitOfFloatsInTiff) {
  const cv::Mat image = floats();
  const cv::Mat read =
      cv::imdecode(encodeImage(image, ImageFormat::kTiff, {}), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.type(), CV_32FC1);
  ASSERT_EQ(read.size(), image.size());
  EXPECT_EQ(std::memcmp(read.data, image.data, image.total() * sizeof(float)), 0);
}

TEST(ImageEncoder, MakesTheSameTiffOfTheSameFloats) {
  const cv::Mat image = floats();
  cv::Mat with_gaps(image.rows, image.cols + 3, image.type(), cv::Scalar(7.0));
  image.copyTo(with_gaps.colRange(0, image.cols));
  const std::vector<uchar> bytes = encodeImage(image, ImageFormat::kTiff, {});
  EXPECT_EQ(bytes, encodeImage(image, ImageFormat::kTiff, {}));
  EXPECT_EQ(bytes, encodeImage(with_gaps.colRange(0, image.cols), ImageFormat::kTiff, {}));
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
  EXPECT_EQ(imageProblem("a.tiff", floats()), std::nullopt);
  EXPECT_THAT(imageProblem("a.png", floats()), Optional(HasSubstr("should end in .tiff")));
  EXPECT_THAT(imageProblem("a.jpg", floats()), Optional(HasSubstr("should end in .tiff")));
  EXPECT_THAT(imageProblem("a.tiff", ramp(CV_64FC1)), Optional(HasSubstr("CV_64FC1")));
  EXPECT_THAT(imageProblem("a.jpg", ramp(CV_16UC1)), Optional(HasSubstr("16 bit")));
}

}  // namespace image_encoder_test
}  // namespace synthetic_dataset::base

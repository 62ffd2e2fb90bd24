#include "base/image/depth_picture.h"

#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"

namespace synthetic_dataset::base {
namespace depth_picture_test {

using ::testing::ElementsAre;
using ::testing::FloatEq;
using ::testing::HasSubstr;
using ::testing::Pointwise;

template <class Number>
RawPicture pictureOf(const std::string& encoding, const std::vector<Number>& row) {
  RawPicture picture;
  picture.width = static_cast<std::uint32_t>(row.size());
  picture.height = 1;
  picture.encoding = encoding;
  picture.step = row.size() * sizeof(Number);
  picture.data.resize(picture.step);
  std::memcpy(picture.data.data(), row.data(), picture.step);
  return picture;
}

std::vector<float> valuesOf(const cv::Mat& depth) {
  return {depth.begin<float>(), depth.end<float>()};
}

/// A depth image as compressed_depth_image_transport writes it: a header of 12 bytes and a PNG.
std::vector<std::uint8_t> compressed(const cv::Mat& numbers, float a, float b) {
  std::vector<std::uint8_t> file(12, 0);
  std::memcpy(file.data() + 4, &a, sizeof a);
  std::memcpy(file.data() + 8, &b, sizeof b);
  std::vector<std::uint8_t> png;
  cv::imencode(".png", numbers, png);
  file.insert(file.end(), png.begin(), png.end());
  return file;
}

TEST(DepthPicture, IsInMetresOrMillimetres) {
  EXPECT_THAT(valuesOf(depthOf(pictureOf<float>("32FC1", {1.5F, 0.25F}))),
              Pointwise(FloatEq(), std::vector<float>{1.5F, 0.25F}));
  EXPECT_THAT(valuesOf(depthOf(pictureOf<std::uint16_t>("16UC1", {1500, 0, 65535}))),
              Pointwise(FloatEq(), std::vector<float>{1.5F, 0.0F, 65.535F}));
  RawPicture swapped = pictureOf<std::uint16_t>("16UC1", {0x0102});
  swapped.is_bigendian = true;
  EXPECT_THAT(valuesOf(depthOf(swapped)), Pointwise(FloatEq(), std::vector<float>{0.513F}))
      << "0x0201";
}

TEST(DepthPicture, HasNothingWhereNothingWasMeasured) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_THAT(valuesOf(depthOf(pictureOf<float>("32FC1", {nan, infinite, -infinite, -1.0F, 2.0F}))),
              Pointwise(FloatEq(), std::vector<float>{0.0F, 0.0F, 0.0F, 0.0F, 2.0F}));
}

TEST(DepthPicture, IsDecompressed) {
  const cv::Mat numbers = (cv::Mat_<std::uint16_t>(1, 3) << 0, 1200, 3000);
  EXPECT_THAT(valuesOf(depthOfCompressed(compressed(numbers, 0, 0), "16UC1; compressedDepth png")),
              Pointwise(FloatEq(), std::vector<float>{0.0F, 1.2F, 3.0F}));
  // Inverse depths: a / (number - b).
  EXPECT_THAT(
      valuesOf(depthOfCompressed(compressed(numbers, 3000, 200), "32FC1; compressedDepth png")),
      Pointwise(FloatEq(), std::vector<float>{0.0F, 3.0F, 3000.0F / 2800.0F}));
  EXPECT_EQ(checkCompressedDepth(compressed(numbers, 0, 0), "16UC1; compressedDepth").width, 3);
}

TEST(DepthPicture, SaysWhyItCannotBeRead) {
  EXPECT_THAT(*depthProblem(pictureOf<std::uint8_t>("mono8", {1})),
              HasSubstr("has the encoding 'mono8'; depth should be 32FC1 [m] or 16UC1 [mm]"));
  RawPicture cut = pictureOf<float>("32FC1", {1.0F, 2.0F});
  cut.data.pop_back();
  EXPECT_EQ(*depthProblem(cut), "has 7 bytes; its 2 x 1 depths need 8");
  const auto failure = [](const std::vector<std::uint8_t>& file, const std::string& format) {
    return test::messagesOf([&] { (void)checkCompressedDepth(file, format); });
  };
  EXPECT_THAT(failure({1, 2, 3}, "jpeg"), ElementsAre(HasSubstr("the topic .../compressedDepth")));
  EXPECT_THAT(failure({1, 2, 3}, "16UC1; compressedDepth rvl"),
              ElementsAre(HasSubstr("has the format '16UC1; compressedDepth rvl'; it should be")));
  EXPECT_THAT(failure({1, 2, 3}, "16UC1; compressedDepth png"),
              ElementsAre(HasSubstr("has 3 bytes of compressedDepth; its header has 12")));
}

}  // namespace depth_picture_test
}  // namespace synthetic_dataset::base

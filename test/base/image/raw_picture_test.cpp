#include "base/image/raw_picture.h"

#include <map>
#include <utility>

#include <gmock/gmock.h>

namespace synthetic_dataset::base {
namespace raw_picture_test {

using ::testing::HasSubstr;

RawPicture pictureOf(std::uint32_t width, std::uint32_t height, const std::string& encoding,
                     std::vector<std::uint8_t> data) {
  const std::size_t step = data.size() / height;
  return {width, height, encoding, false, step, std::move(data)};
}

/// The first pixel: blue, green, red.
cv::Vec3b first(const RawPicture& picture) { return coloursOf(picture).at<cv::Vec3b>(0, 0); }

TEST(RawPicture, OfEightBitsIsWhatItWas) {
  const cv::Vec3b orange(10, 100, 200);  // blue, green, red
  EXPECT_EQ(first(pictureOf(1, 1, "bgr8", {10, 100, 200})), orange);
  EXPECT_EQ(first(pictureOf(1, 1, "rgb8", {200, 100, 10})), orange);
  EXPECT_EQ(first(pictureOf(1, 1, "bgra8", {10, 100, 200, 7})), orange);
  EXPECT_EQ(first(pictureOf(1, 1, "rgba8", {200, 100, 10, 7})), orange);
  EXPECT_EQ(first(pictureOf(1, 1, "8UC3", {10, 100, 200})), orange);
  EXPECT_EQ(first(pictureOf(1, 1, "mono8", {77})), cv::Vec3b(77, 77, 77));
}

TEST(RawPicture, OfSixteenBitsHasItsRangeInEight) {
  EXPECT_EQ(first(pictureOf(1, 1, "mono16", {0xFF, 0xFF})), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(first(pictureOf(1, 1, "mono16", {0x01, 0x01})), cv::Vec3b(1, 1, 1)) << "257 of 65535";
  RawPicture swapped = pictureOf(1, 1, "mono16", {0x80, 0x00});
  swapped.is_bigendian = true;
  EXPECT_EQ(first(swapped), cv::Vec3b(128, 128, 128)) << "0x8000";
  EXPECT_EQ(first(pictureOf(1, 1, "rgb16", {0xFF, 0xFF, 0, 0, 0, 0})), cv::Vec3b(0, 0, 255));
}

/// A plain colour as seen by a sensor behind a mosaic of colour filters.
std::vector<std::uint8_t> mosaic(const std::string& pattern) {
  const std::map<char, std::uint8_t> colour = {{'r', 200}, {'g', 100}, {'b', 10}};
  std::vector<std::uint8_t> data;
  for (std::size_t row = 0; row < 6; ++row) {
    for (std::size_t column = 0; column < 6; ++column) {
      data.push_back(colour.at(pattern[row % 2 * 2 + column % 2]));
    }
  }
  return data;
}

TEST(RawPicture, OfAMosaicHasTheColourThatFellOnIt) {
  for (const std::string pattern : {"rggb", "bggr", "gbrg", "grbg"}) {
    const cv::Mat colours = coloursOf(pictureOf(6, 6, "bayer_" + pattern + "8", mosaic(pattern)));
    EXPECT_EQ(colours.at<cv::Vec3b>(2, 2), cv::Vec3b(10, 100, 200)) << pattern;
    EXPECT_EQ(colours.at<cv::Vec3b>(3, 2), cv::Vec3b(10, 100, 200)) << pattern;
  }
}

/// The same values in 16 bits: each byte twice, so that the upper byte is the 8-bit value.
std::vector<std::uint8_t> widened(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint8_t> wide;
  for (const std::uint8_t each : bytes) wide.insert(wide.end(), {each, each});
  return wide;
}

TEST(RawPicture, OfAMosaicOfSixteenBitsHasTheColourThatFellOnIt) {
  for (const std::string pattern : {"rggb", "bggr", "gbrg", "grbg"}) {
    const cv::Mat colours =
        coloursOf(pictureOf(6, 6, "bayer_" + pattern + "16", widened(mosaic(pattern))));
    EXPECT_EQ(colours.at<cv::Vec3b>(2, 2), cv::Vec3b(10, 100, 200)) << pattern;
    EXPECT_EQ(colours.at<cv::Vec3b>(3, 2), cv::Vec3b(10, 100, 200)) << pattern;
  }
}

TEST(RawPicture, OfSeveralChannelsOfSixteenBitsHasTheirOrder) {
  const cv::Vec3b orange(10, 100, 200);  // blue, green, red
  const std::map<std::string, std::vector<std::uint8_t>> pixels = {
      {"bgr16", {10, 100, 200}},     {"16UC3", {10, 100, 200}},     {"rgb16", {200, 100, 10}},
      {"bgra16", {10, 100, 200, 7}}, {"rgba16", {200, 100, 10, 7}}, {"16UC4", {10, 100, 200, 7}}};
  for (const auto& [encoding, bytes] : pixels) {
    EXPECT_EQ(first(pictureOf(1, 1, encoding, widened(bytes))), orange) << encoding;
  }
  EXPECT_EQ(first(pictureOf(1, 1, "8UC4", {10, 100, 200, 7})), orange);
  EXPECT_EQ(first(pictureOf(1, 1, "8UC1", {77})), cv::Vec3b(77, 77, 77));
  EXPECT_EQ(first(pictureOf(1, 1, "16UC1", {0x80, 0x80})), cv::Vec3b(128, 128, 128));
}

TEST(RawPicture, OfHalfTheColoursHasThemForBothPixels) {
  // Red by ITU-R BT.601: y 82, u 90, v 240.
  const std::map<std::string, std::vector<std::uint8_t>> pixels = {
      {"yuv422", {90, 82, 240, 82}},
      {"uyvy", {90, 82, 240, 82}},
      {"yuv422_yuy2", {82, 90, 82, 240}},
      {"yuyv", {82, 90, 82, 240}}};
  for (const auto& [encoding, bytes] : pixels) {
    const cv::Mat colours = coloursOf(pictureOf(2, 1, encoding, bytes));
    for (int x = 0; x < 2; ++x) {
      const cv::Vec3b colour = colours.at<cv::Vec3b>(0, x);
      EXPECT_LE(colour[0], 2) << encoding;
      EXPECT_LE(colour[1], 2) << encoding;
      EXPECT_GE(colour[2], 253) << encoding;
    }
  }
}

TEST(RawPicture, OfHalfTheColoursIsGreyWhereTheyAreNeutral) {
  // u y v y and y u y v; chroma of 128 is neutral, and luma from 16 to 235 is black to white.
  EXPECT_EQ(first(pictureOf(2, 1, "yuv422", {128, 235, 128, 16})), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(first(pictureOf(2, 1, "yuv422_yuy2", {235, 128, 16, 128})), cv::Vec3b(255, 255, 255));
}

TEST(RawPicture, SkipsWhatFollowsItsRows) {
  const RawPicture padded = pictureOf(1, 2, "mono8", {5, 0, 0, 0, 9, 0, 0, 0});
  const cv::Mat colours = coloursOf(padded);
  EXPECT_EQ(colours.at<cv::Vec3b>(0, 0)[0], 5);
  EXPECT_EQ(colours.at<cv::Vec3b>(1, 0)[0], 9);
}

TEST(RawPicture, SaysWhyItCannotBeRead) {
  EXPECT_THAT(*pictureProblem(pictureOf(1, 1, "bgr10", {1, 2, 3})),
              HasSubstr("has the encoding 'bgr10', which cannot be read; 16UC1"));
  RawPicture picture = pictureOf(2, 2, "bgr8", std::vector<std::uint8_t>(12));
  picture.data.pop_back();
  EXPECT_EQ(*pictureProblem(picture), "has 11 bytes; its 2 x 2 pixels need 12");
  picture.step = 5;
  EXPECT_EQ(*pictureProblem(picture),
            "has rows of 5 bytes (step); 2 pixels of encoding bgr8 need 6");
  EXPECT_THAT(*pictureProblem(pictureOf(3, 1, "yuv422", std::vector<std::uint8_t>(6))),
              HasSubstr("its width should be even"));
  EXPECT_THAT(*pictureProblem(pictureOf(1, 1, "32FC1", {0, 0, 0, 0})), HasSubstr("cannot be read"))
      << "depth is no colour";
}

}  // namespace raw_picture_test
}  // namespace synthetic_dataset::base

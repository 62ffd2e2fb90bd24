#include "render/pixels/mipmaps.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace mipmaps_test {

cv::Mat randomPicture(const cv::Size& size) {
  cv::Mat picture(size, CV_8UC4);
  cv::RNG(7).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

/// How much of a pixel of a long line a pixel of a shorter line covers [pixels of the long line].
double covered(int place, int length, int shorter_place, int shorter) {
  const double scale = static_cast<double>(length) / shorter;
  return std::max(0.0, std::min(place + 1.0, (shorter_place + 1) * scale) -
                           std::max(place + 0.0, shorter_place * scale));
}

/// The mean of what a pixel of a smaller picture covers, from all pixels of the large one.
cv::Vec4b meanOfArea(const cv::Mat& picture, const cv::Size& size, const cv::Point& at,
                     PixelMeaning meaning) {
  std::array<double, 4> sums{};
  double area = 0.0;
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) {
      const double share =
          covered(u, picture.cols, at.x, size.width) * covered(v, picture.rows, at.y, size.height);
      area += share;
      for (int c = 0; c < 4; ++c) {
        const float number = static_cast<float>(picture.at<cv::Vec4b>(v, u)[c]) / 255.0F;
        const bool is_light = meaning == PixelMeaning::kColour && c < 3;
        sums.at(static_cast<std::size_t>(c)) +=
            share * (is_light ? render::linearFromSrgb(number) : number);
      }
    }
  }
  cv::Vec4b mean;
  for (int c = 0; c < 4; ++c) {
    const double number = sums.at(static_cast<std::size_t>(c)) / area;
    const bool is_light = meaning == PixelMeaning::kColour && c < 3;
    mean[c] = is_light ? render::srgbFromLinear(static_cast<float>(number))
                       : cv::saturate_cast<std::uint8_t>(255.0 * number);
  }
  return mean;
}

TEST(Mipmaps, AreHalfAsLargeDownToOnePixel) {
  std::vector<cv::Size> sizes;
  for (const cv::Mat& each : mipmapsOf(randomPicture({13, 4}), PixelMeaning::kColour)) {
    sizes.push_back(each.size());
  }
  EXPECT_EQ(sizes, (std::vector<cv::Size>{{6, 2}, {3, 1}, {1, 1}}));
  EXPECT_TRUE(mipmapsOf(randomPicture({1, 1}), PixelMeaning::kColour).empty());
}

TEST(Mipmaps, AreMeansOfWhatTheyCover) {
  for (const cv::Size& size : {cv::Size(64, 32), {33, 47}, {3, 5}, {1, 9}, {130, 1}}) {
    const cv::Mat picture = randomPicture(size);
    for (const PixelMeaning meaning : {PixelMeaning::kColour, PixelMeaning::kData}) {
      for (cv::Mat& each : mipmapsOf(picture, meaning)) {
        // With odd lengths, a mean of means is not the mean of all pixels.
        const bool is_first = each.rows >= size.height / 2 && each.cols >= size.width / 2;
        if (!is_first && size.area() != 64 * 32) continue;
        each.forEach<cv::Vec4b>([&](cv::Vec4b& pixel, const int* place) {
          const cv::Vec4b truth = meanOfArea(picture, each.size(), {place[1], place[0]}, meaning);
          EXPECT_LE(cv::norm(pixel, truth, cv::NORM_INF), 1.0) << size << " to " << each.size();
        });
      }
    }
  }
}

TEST(Mipmaps, OfBlackAndWhiteHaveHalfTheLight) {
  cv::Mat picture(2, 2, CV_8UC4, cv::Scalar(0, 0, 0, 0));
  picture.at<cv::Vec4b>(0, 0) = picture.at<cv::Vec4b>(1, 1) = {255, 255, 255, 255};
  const auto only = [&](PixelMeaning meaning) {
    return mipmapsOf(picture, meaning).back().at<cv::Vec4b>(0, 0);
  };
  EXPECT_EQ(only(PixelMeaning::kColour), cv::Vec4b(188, 188, 188, 128));
  EXPECT_EQ(only(PixelMeaning::kData), cv::Vec4b(128, 128, 128, 128));
}

TEST(Mipmaps, KeepEveryColourThatIsEverywhere) {
  for (int value = 0; value < 256; ++value) {
    const cv::Mat picture(5, 7, CV_8UC4, cv::Scalar(value, 255 - value, value, value));
    for (const PixelMeaning meaning : {PixelMeaning::kColour, PixelMeaning::kData}) {
      for (const cv::Mat& each : mipmapsOf(picture, meaning)) {
        EXPECT_EQ(each.at<cv::Vec4b>(0, 0), picture.at<cv::Vec4b>(0, 0));
      }
    }
  }
}

/// A part of a picture, whose rows do not follow one another.
TEST(Mipmaps, OfPartsAreThoseOfTheirPixelsAlone) {
  const cv::Mat part = randomPicture({20, 20})(cv::Rect(3, 4, 10, 6));
  const std::vector<cv::Mat> mipmaps = mipmapsOf(part, PixelMeaning::kColour);
  const std::vector<cv::Mat> of_copy = mipmapsOf(part.clone(), PixelMeaning::kColour);
  ASSERT_EQ(mipmaps.size(), of_copy.size());
  for (std::size_t i = 0; i < mipmaps.size(); ++i) {
    EXPECT_EQ(cv::norm(mipmaps[i], of_copy[i], cv::NORM_INF), 0.0);
  }
}

}  // namespace mipmaps_test
}  // namespace synthetic_dataset::render

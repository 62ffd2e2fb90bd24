#include "render/pixels/mipmaps.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

cv::Mat randomPicture(const cv::Size& size) {
  cv::Mat picture(size, CV_8UC4);
  cv::RNG(7).fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

/// OpenCV's mean of what each pixel of the smaller picture covers.
cv::Mat meanOfAreas(const cv::Mat& picture, const cv::Size& size, PixelMeaning meaning) {
  cv::Mat numbers;
  picture.convertTo(numbers, CV_32FC4, 1.0 / 255.0);
  const bool is_colour = meaning == PixelMeaning::kColour;
  numbers.forEach<cv::Vec4f>([&](cv::Vec4f& pixel, const int*) {
    for (int c = 0; c < 3 && is_colour; ++c) pixel[c] = sensor::linearFromSrgb(pixel[c]);
  });
  cv::resize(numbers, numbers, size, 0.0, 0.0, cv::INTER_AREA);
  cv::Mat bytes(size, CV_8UC4);
  bytes.forEach<cv::Vec4b>([&](cv::Vec4b& pixel, const int* place) {
    const auto& mean = numbers.at<cv::Vec4f>(place);
    for (int c = 0; c < 4; ++c) {
      pixel[c] = is_colour && c < 3 ? sensor::srgbFromLinear(mean[c])
                                    : cv::saturate_cast<std::uint8_t>(255.0F * mean[c]);
    }
  });
  return bytes;
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
      for (const cv::Mat& each : mipmapsOf(picture, meaning)) {
        // Where lengths are odd, a mean of means is not that of all.
        const bool is_first = each.rows >= size.height / 2 && each.cols >= size.width / 2;
        if (!is_first && size.area() != 64 * 32) continue;
        const cv::Mat truth = meanOfAreas(picture, each.size(), meaning);
        EXPECT_LE(cv::norm(each, truth, cv::NORM_INF), 1.0) << size << " to " << each.size();
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

}  // namespace
}  // namespace synthetic_dataset::render

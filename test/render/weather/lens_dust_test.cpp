#include "render/weather/lens_dust.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace lens_dust_test {

CameraModel cameraOf(double focal_length, int width = 640, int height = 480) {
  return {width,
          height,
          {focal_length, focal_length, 0.5 * width - 0.5, 0.5 * height - 0.5},
          0.05,
          100.0};
}

cv::Mat plain(const CameraModel& camera, int level) {
  return {camera.height(), camera.width(), CV_8UC3, cv::Scalar::all(level)};
}

/// The rows and columns with pixels that differ from a plain picture's.
cv::Rect changed(const cv::Mat& picture, int level) {
  cv::Mat channel;
  cv::extractChannel(picture, channel, 0);
  cv::Rect box;
  for (int v = 0; v < channel.rows; ++v) {
    for (int u = 0; u < channel.cols; ++u) {
      if (channel.at<std::uint8_t>(v, u) != level) box |= cv::Rect(u, v, 1, 1);
    }
  }
  return box;
}

TEST(LensDust, TakesHalfOfWhatItCovers) {
  const CameraModel camera = cameraOf(400.0);
  constexpr double kShare = 0.05;
  double lost = 0.0;
  constexpr int kSeeds = 12;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const cv::Mat seen = throughDust(plain(camera, 200), camera, {kShare, seed});
    const double before = linearFromSrgb()[200];
    for (int v = 0; v < seen.rows; ++v) {
      for (int u = 0; u < seen.cols; ++u) {
        lost += 1.0 - double{linearFromSrgb()[seen.at<cv::Vec3b>(v, u)[1]]} / before;
      }
    }
  }
  const double pixels = kSeeds * static_cast<double>(camera.width()) * camera.height();
  EXPECT_NEAR(lost / pixels, 0.5 * kShare, 0.1 * 0.5 * kShare);
}

TEST(LensDust, IsDiscsAsWideAsTheApertureOnTheGlass) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const CameraModel camera = cameraOf(400.0);
    const cv::Rect box = changed(throughDust(plain(camera, 255), camera, {2e-4, seed}), 255);
    const cv::Rect inner(1, 1, camera.width() - 2, camera.height() - 2);
    // A single speck that is entirely in the picture.
    if (box.empty() || (box & inner) != box || std::abs(box.width - box.height) > 1) continue;
    ++found;
    // 2 mm at 2 cm, plus the speck's own 0.1 to 1 mm; what is fainter than a grey level is
    // invisible.
    EXPECT_GE(box.width, 34) << seed;
    EXPECT_LE(box.width, 62) << seed;
    // A lens of twice the focal length shows the same speck twice as large, as far from its axis.
    const CameraModel longer = cameraOf(800.0, 1280, 960);
    const cv::Rect larger = changed(throughDust(plain(longer, 255), longer, {2e-4, seed}), 255);
    EXPECT_NEAR(larger.width, 2 * box.width, 4) << seed;
    EXPECT_NEAR(larger.x + 0.5 * larger.width, 2.0 * (box.x + 0.5 * box.width), 3.0) << seed;
  }
  EXPECT_GT(found, 3);
}

TEST(LensDust, DimsWhatIsBrightAndVeilsWhatIsDark) {
  const CameraModel camera = cameraOf(400.0);
  cv::Mat picture = plain(camera, 0);
  picture.rowRange(0, 240).setTo(cv::Scalar::all(255));
  const cv::Mat seen = throughDust(picture, camera, {0.05, 4});
  EXPECT_LT(cv::mean(seen.rowRange(0, 200))[0], 254.0);
  EXPECT_GT(cv::mean(seen.rowRange(280, 480))[0], 1.0);
}

TEST(LensDust, HasItsPlacesByItsSeedAndMoreOfItWithALargerShare) {
  const CameraModel camera = cameraOf(400.0);
  const cv::Mat white = plain(camera, 255);
  const cv::Mat some = throughDust(white, camera, {0.01, 7});
  EXPECT_EQ(cv::norm(some, throughDust(white, camera, {0.01, 7}), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(some, throughDust(white, camera, {0.01, 8}), cv::NORM_INF), 3.0);
  const cv::Mat more = throughDust(white, camera, {0.03, 7});
  EXPECT_EQ(cv::countNonZero(cv::Mat(more > some).reshape(1)), 0);
  EXPECT_GT(cv::countNonZero(cv::Mat(more < some).reshape(1)), 1000);
}

TEST(LensDust, OfNoneLeavesThePicture) {
  const CameraModel camera = cameraOf(400.0);
  cv::Mat picture = plain(camera, 0);
  cv::theRNG().state = 3;
  cv::randu(picture, 0, 256);
  EXPECT_EQ(cv::norm(picture, throughDust(picture, camera, {0.0, 7}), cv::NORM_INF), 0.0);
}

}  // namespace lens_dust_test
}  // namespace synthetic_dataset::render

/// Noise of depth, compared with the published formulas by statistics over many pixels.

#include "render/sensor/depth_noise.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace depth_noise_test {

const CameraModel kCamera(400, 300, {585.0, 585.0, 199.5, 149.5}, 0.05, 100.0);

DepthNoise structuredLight() {
  DepthNoise noise;
  noise.model = DepthModel::kStructuredLight;
  noise.baseline = 0.075;
  noise.disparity_step = 0.125;
  noise.greatest_angle = 1.4;
  noise.min_depth = 0.5;
  noise.max_depth = 5.0;
  return noise;
}

DepthNoise stereo() {
  DepthNoise noise;
  noise.model = DepthModel::kStereo;
  noise.baseline = 0.05;
  noise.disparity_step = 0.03125;
  noise.disparity_noise = 0.08;
  return noise;
}

cv::Mat wallAt(double depth) { return {300, 400, CV_32FC1, cv::Scalar(depth)}; }

/// A plane through the optical axis at a depth [m], turned about the camera's y axis by an angle.
cv::Mat turnedWall(double depth, double angle) {
  cv::Mat_<float> wall(300, 400);
  for (int v = 0; v < wall.rows; ++v) {
    for (int u = 0; u < wall.cols; ++u) {
      wall(v, u) = static_cast<float>(depth / (1.0 - std::tan(angle) * (u - 199.5) / 585.0));
    }
  }
  return wall;
}

struct Statistics {
  double mean = 0.0;
  double deviation = 0.0;
  double measured = 0.0;  ///< share of the pixels
};

/// The statistics of a value of each pixel's measured depth.
Statistics statisticsOf(const cv::Mat_<float>& depth, const cv::Rect& region,
                        const std::function<double(int u, int v, double depth)>& value) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int v = region.y; v < region.br().y; ++v) {
    for (int u = region.x; u < region.br().x; ++u) {
      if (depth(v, u) == 0.0F) continue;
      const double each = value(u, v, depth(v, u));
      sum += each;
      squares += each * each;
      ++count;
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean),
          static_cast<double>(count) / region.area()};
}

Statistics errorsOf(const cv::Mat& measured, double depth, const cv::Rect& region) {
  return statisticsOf(measured, region, [&](int, int, double each) { return each - depth; });
}

const cv::Rect kMiddle(60, 10, 330, 280);  // right of the strip that the second camera misses

TEST(StructuredLight, HasTheDeviationThatWasMeasuredOfAKinect) {
  for (const double depth : {0.8, 1.5, 2.5, 4.0}) {
    const Statistics errors =
        errorsOf(measuredDepth(wallAt(depth), kCamera, structuredLight(), 7), depth, kMiddle);
    const double expected = 0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4);
    EXPECT_NEAR(errors.deviation, expected, 0.03 * expected) << depth;
    EXPECT_NEAR(errors.mean, 0.0, 0.05 * expected) << depth;
    EXPECT_EQ(errors.measured, 1.0) << depth;
  }
}

TEST(StructuredLight, IsNoisierAtGrazingAnglesAndAlongTheImage) {
  const double angle = 1.2;
  const cv::Mat wall = turnedWall(2.0, angle);
  const cv::Rect column(195, 10, 10, 280);  // where the ray is nearly the axis
  const Statistics errors =
      statisticsOf(measuredDepth(wall, kCamera, structuredLight(), 3), column,
                   [&](int u, int v, double depth) { return depth - wall.at<float>(v, u); });
  const double rest = M_PI_2 - angle;
  const double axial =
      0.0012 + 0.0019 * 1.6 * 1.6 + 0.0001 / std::sqrt(2.0) * std::pow(angle / rest, 2);
  // Lateral noise picks the depth of a nearby pixel, which is nearer or farther.
  const double lateral =
      std::hypot(0.8 + 0.035 * angle / rest, 1.0 / std::sqrt(12.0)) * 2.0 * std::tan(angle) / 585.0;
  EXPECT_NEAR(errors.deviation, std::hypot(axial, lateral), 0.1 * std::hypot(axial, lateral));
}

TEST(StructuredLight, HasDepthsOfWholeStepsOfDisparity) {
  const cv::Mat measured = measuredDepth(wallAt(3.0), kCamera, structuredLight(), 1);
  for (const float depth : cv::Mat_<float>(measured)) {
    const double steps = 585.0 * 0.075 / depth / 0.125;
    ASSERT_NEAR(steps, std::round(steps), 1e-3);
  }
}

TEST(StructuredLight, MeasuresNothingAtGrazingAnglesOrOutOfRange) {
  const auto measuredShare = [](const cv::Mat& depth) {
    return errorsOf(measuredDepth(depth, kCamera, structuredLight(), 1), 0.0, {195, 10, 10, 280})
        .measured;
  };
  EXPECT_EQ(measuredShare(turnedWall(2.0, 1.5)), 0.0);
  EXPECT_EQ(measuredShare(turnedWall(2.0, 1.2)), 1.0);
  EXPECT_EQ(measuredShare(wallAt(0.45)), 0.0);
  EXPECT_EQ(measuredShare(wallAt(5.1)), 0.0);
  EXPECT_EQ(measuredShare(wallAt(0.0)), 0.0);
  EXPECT_EQ(measuredShare(wallAt(-2.0)), 0.0) << "behind a wide lens";
}

TEST(StructuredLight, LosesTheShadowAndHalfOfTheEdges) {
  cv::Mat depth = wallAt(3.0);
  depth(cv::Rect(200, 0, 100, 300)).setTo(1.0);
  DepthNoise noise = structuredLight();
  const cv::Mat measured = measuredDepth(depth, kCamera, noise, 5);
  const auto share = [&](const cv::Rect& region) {
    return errorsOf(measured, 0.0, region).measured;
  };
  // The shadow is 585 * 0.075 * (1/1 - 1/3) = 29.25 pixels wide; its rims are ragged.
  EXPECT_EQ(share({180, 0, 12, 300}), 0.0);
  EXPECT_EQ(share({120, 0, 45, 300}), 1.0);
  EXPECT_EQ(share({210, 0, 80, 300}), 1.0);
  EXPECT_EQ(share({310, 0, 80, 300}), 1.0);
  // Along the right edge, some pixels are lost: those on both sides, and those that show one of
  // them.
  EXPECT_NEAR(share({299, 0, 2, 300}), 0.65, 0.12);
}

TEST(StereoDepth, HasADeviationThatGrowsWithTheSquareOfTheDepth) {
  const double disparity = std::hypot(0.08, 0.03125 / std::sqrt(12.0));
  for (const double depth : {0.5, 1.0, 2.0, 4.0}) {
    const Statistics errors =
        errorsOf(measuredDepth(wallAt(depth), kCamera, stereo(), 7), depth, kMiddle);
    const double expected = depth * depth / (585.0 * 0.05) * disparity;
    EXPECT_NEAR(errors.deviation, expected, 0.03 * expected) << depth;
    EXPECT_EQ(errors.measured, 1.0) << depth;
  }
}

TEST(StereoDepth, HasNothingInABandToTheLeftOfNearThings) {
  cv::Mat depth = wallAt(3.0);
  depth(cv::Rect(200, 100, 80, 100)).setTo(0.9);
  const cv::Mat_<float> measured = measuredDepth(depth, kCamera, stereo(), 1);
  // 585 * 0.05 * (1/0.9 - 1/3) = 22.75 pixels
  for (int u = 20; u < 400; ++u) {
    EXPECT_EQ(measured(150, u) == 0.0F, u >= 178 && u < 200) << u;
    EXPECT_NE(measured(50, u), 0.0F) << u;
  }
}

TEST(StereoDepth, HasNothingThatTheSecondCameraDoesNotSee) {
  const cv::Mat_<float> measured = measuredDepth(wallAt(1.0), kCamera, stereo(), 1);
  for (int u = 0; u < 400; ++u) EXPECT_EQ(measured(20, u) == 0.0F, u < 29) << u;  // 29.25 px
}

TEST(DepthNoise, IsThatOfItsSeed) {
  for (const DepthNoise& noise : {structuredLight(), stereo()}) {
    const cv::Mat one = measuredDepth(wallAt(2.0), kCamera, noise, 1);
    EXPECT_EQ(cv::norm(one, measuredDepth(wallAt(2.0), kCamera, noise, 1)), 0.0);
    EXPECT_GT(cv::norm(one, measuredDepth(wallAt(2.0), kCamera, noise, 2)), 0.0);
  }
}

TEST(DepthNoise, IsNoneUnlessAskedFor) {
  EXPECT_EQ(cv::norm(measuredDepth(wallAt(2.0), kCamera, {}, 1), wallAt(2.0)), 0.0);
}

}  // namespace depth_noise_test
}  // namespace synthetic_dataset::render

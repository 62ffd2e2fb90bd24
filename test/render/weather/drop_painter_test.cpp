#include "render/weather/drop_painter.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace drop_painter_test {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// A camera that looks along the global x; z is up, and v grows downwards.
Pose lookingAlongX() {
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return makePose({0.3, -0.2, 1.4}, Eigen::Quaterniond(R));
}

struct Shot {
  double exposure = 0.001;
  Eigen::Vector3d wind{0, 0, 0};
  float wall = std::numeric_limits<float>::infinity();
  std::uint64_t seed = 4;

  /// The share of the light that passes, CV_32FC1.
  [[nodiscard]] cv::Mat of(const Precipitation& falling) const {
    const View view{CameraModel(kWidth, kHeight, {300, 300, 159.5, 119.5}, 0.05, 100.0),
                    lookingAlongX()};
    const cv::Mat distances(kHeight, kWidth, CV_32FC1, cv::Scalar(wall));
    cv::Mat passing(kHeight, kWidth, CV_32FC1, cv::Scalar(1.0));
    drawDrops(falling, wind, exposure, view, seed, distances, passing);
    return passing;
  }
};

/// The mean loss of light, as a negative logarithm.
double lost(const cv::Mat& passing) {
  cv::Mat logarithms;
  cv::log(passing, logarithms);
  return -cv::mean(logarithms)[0];
}

TEST(Drops, TakeTheLightThatTheirOutlinesTake) {
  // Beer and Lambert: the drops' outlines in a cubic metre, times the path of 10 m. Near drops are
  // few and large in the image, so many instants are averaged.
  const Precipitation rain = Precipitation::rain(100.0);
  double outlines = 0.0;
  constexpr int kCells = 100;
  for (int i = 0; i < kCells; ++i) {
    for (const Drop& drop : rain.in({i, 0, 0}, 3e-4, 1)) {
      outlines += M_PI / 4.0 * drop.diameter * drop.diameter / kCells;
    }
  }
  double sum = 0.0;
  constexpr int kInstants = 6;
  for (int i = 0; i < kInstants; ++i) {
    Shot shot;
    shot.exposure = 1e-4;
    shot.seed = static_cast<std::uint64_t>(i);
    sum += lost(shot.of(rain)) / kInstants;
  }
  EXPECT_NEAR(sum / (outlines * 10.0), 0.85, 0.2);  // the faintest drops are not drawn
}

TEST(Drops, TakeTheSameLightHoweverLongTheyFall) {
  const Precipitation rain = Precipitation::rain(100.0);
  Shot brief;
  brief.exposure = 1e-4;
  Shot longer;
  longer.exposure = 2e-3;
  const double ratio = lost(longer.of(rain)) / lost(brief.of(rain));
  EXPECT_GT(ratio, 0.6);  // streaks are fainter, and some too faint
  EXPECT_LT(ratio, 1.1);
}

/// How different pixels are from their neighbours at (du, dv).
double roughness(const cv::Mat& image, int du, int dv) {
  const cv::Rect first(0, 0, image.cols - du, image.rows - dv);
  return cv::norm(image(first), image(first + cv::Point(du, dv)), cv::NORM_L2SQR);
}

TEST(Drops, FallDownTheImageAndDriftWithTheWind) {
  const Precipitation rain = Precipitation::rain(50.0);
  Shot shot;
  shot.exposure = 0.01;
  const cv::Mat still = shot.of(rain);
  EXPECT_LT(2.0 * roughness(still, 0, 1), roughness(still, 1, 0));
  shot.wind = {0, -60, 0};  // to the right of the image
  const cv::Mat windy = shot.of(rain);
  EXPECT_LT(2.0 * roughness(windy, 1, 0), roughness(windy, 0, 1));
}

TEST(Drops, AreHiddenByWhatIsNearer) {
  const Precipitation snow = Precipitation::snow(2.0);
  Shot shot;
  const cv::Mat open = shot.of(snow);
  shot.wall = 1.5F;
  const cv::Mat walled = shot.of(snow);
  shot.wall = 0.04F;
  const cv::Mat covered = shot.of(snow);
  EXPECT_LT(2.0 * lost(walled), lost(open));
  EXPECT_GT(lost(walled), 0.0);
  EXPECT_EQ(lost(covered), 0.0);
  cv::Mat more;
  cv::compare(walled, open, more, cv::CMP_LT);
  EXPECT_EQ(cv::countNonZero(more), 0);
}

TEST(Drops, AreTheSameForTheSameSeedAlone) {
  const Precipitation snow = Precipitation::snow(1.0);
  Shot shot;
  const cv::Mat first = shot.of(snow);
  EXPECT_EQ(cv::norm(first, shot.of(snow), cv::NORM_INF), 0.0);
  shot.seed = 5;
  EXPECT_GT(cv::norm(first, shot.of(snow), cv::NORM_INF), 0.1);
}

}  // namespace drop_painter_test
}  // namespace synthetic_dataset::render

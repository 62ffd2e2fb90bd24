/// A lens sees nothing that is nearer than `near`, whichever sides of a cube its picture is made
/// of.

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "label/box_view.h"
#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"

namespace synthetic_dataset::render {
namespace near_limit_test {

using synthetic_dataset::test::distanceTo;
using synthetic_dataset::test::SeenBox;
using synthetic_dataset::test::Stage;
using test::coloured;
using test::dark;
using test::LensCase;

/// A bar beside the camera that begins behind it, and goes past the near plane.
const SeenBox kBar{makePose({0.6, 0.1, 0.8}, Eigen::Quaterniond::Identity()), {0.2, 0.3, 3.0}, 1};

Stage stageOfBar() {
  Stage stage;
  stage.addBox(kBar.size, kBar.X_CB, 0, coloured(1, 1, 1));
  return stage;
}

class LensNearLimit : public ::testing::TestWithParam<LensCase> {
 protected:
  /// Whether the pixel's ray hits the bar at or beyond the near limit.
  [[nodiscard]] bool seesBar(const cv::Point& pixel) const {
    const auto ray = camera_.ray({pixel.x, pixel.y});
    if (!ray) return false;
    const double distance = distanceTo(kBar, *ray);
    return std::isfinite(distance) &&
           distance * (camera_.hasNearPlane() ? ray->z() : 1.0) >= camera_.near();
  }

  const CameraModel& camera_ = GetParam().camera;
  View view_{camera_};
  Stage stage_ = stageOfBar();
  Renderer renderer_{dark(), stage_.links(), {}};
};

TEST_P(LensNearLimit, EndsLabelsPicturesAndSilhouettesAlike) {
  const cv::Mat seen = renderer_.labels(view_, stage_.poses(), {stage_.all()}).ids > 0;
  const Silhouette silhouette = renderer_.silhouette(view_, stage_.poses(), stage_.all());
  ColourPass pass{stage_.all(), stage_.all()};
  pass.sampling = Sampling::kCentre;
  const cv::Mat picture = renderer_.colour(view_, stage_.poses(), pass);
  int wrong = 0;
  int wanted = 0;
  cv::Mat lit(picture.size(), CV_8UC1, cv::Scalar(0));
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) {
      wanted += seesBar({u, v}) ? 1 : 0;
      wrong += seesBar({u, v}) != (seen.at<uchar>(v, u) != 0) ? 1 : 0;
      lit.at<uchar>(v, u) = picture.at<cv::Vec3b>(v, u)[0] > 0 ? 255 : 0;
    }
  }
  EXPECT_GT(wanted, 1000);
  EXPECT_LT(wrong, 0.03 * wanted) << "pixels of outlines";
  EXPECT_EQ(cv::norm(seen, silhouette.mask.whole(), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(seen, lit, cv::NORM_INF), 0.0);
}

/// Smooth edges have the same near limit as pixels' centres.
TEST_P(LensNearLimit, EndsEdges) {
  const cv::Mat seen = renderer_.labels(view_, stage_.poses(), {stage_.all()}).ids > 0;
  const cv::Mat picture = renderer_.colour(view_, stage_.poses(), {stage_.all(), stage_.all()});
  cv::Mat round;
  cv::dilate(seen, round, cv::Mat::ones(5, 5, CV_8UC1));
  cv::Mat beside;
  cv::extractChannel(picture, beside, 0);
  beside.setTo(0, round);
  EXPECT_EQ(cv::countNonZero(beside), 0);
}

const LensCase kWidePlumbBob{"wide_plumb_bob",
                             {320,
                              240,
                              {80.0, 80.0, 160.0, 120.0},
                              0.3,
                              100.0,
                              {DistortionModel::kPlumbBob, {-0.01, 0.0, 0.0, 0.0, 0.0}}}};
const LensCase kWideFisheye{"fisheye",
                            {320,
                             240,
                             {100.0, 100.0, 160.0, 120.0},
                             0.7,
                             100.0,
                             {DistortionModel::kEquidistant, {0.02, -0.008, 0.003, -5e-4}}}};
const LensCase kNarrowFisheye{"narrow_fisheye",
                              {320,
                               240,
                               {190.0, 190.0, 60.0, 120.0},
                               0.9,
                               100.0,
                               {DistortionModel::kEquidistant, {0.02, -0.008, 0.003, -5e-4}}}};

const LensCase kWideSphere{"double_sphere",
                           {320,
                            240,
                            {85.0, 85.0, 160.0, 120.0},
                            0.7,
                            100.0,
                            {DistortionModel::kDoubleSphere, {-0.21, 0.58}}}};

INSTANTIATE_TEST_SUITE_P(Lenses, LensNearLimit,
                         ::testing::Values(kWidePlumbBob, kWideFisheye, kNarrowFisheye,
                                           kWideSphere),
                         [](const auto& lens) { return lens.param.name; });

}  // namespace near_limit_test
}  // namespace synthetic_dataset::render

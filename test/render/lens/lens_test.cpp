#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "support/random_poses.h"

namespace synthetic_dataset::render {
namespace lens_test {

using synthetic_dataset::test::randomOrientation;
using synthetic_dataset::test::Stage;
using test::coloured;
using test::dark;
using test::kFisheye170;
using test::kFisheye190;
using test::kPlumbBob;
using test::kRational;
using test::LensCase;

/// The projection by the formulas of the models' papers, for lenses that calib3d lacks.
cv::Point2d truthOfSpheres(const CameraModel& camera, const Eigen::Vector3d& p) {
  const Intrinsics& k = camera.intrinsics();
  const auto& c = camera.distortion().coefficients;
  const double z = c[0] * p.norm() + p.z();
  if (camera.distortion().model == DistortionModel::kDoubleSphere) {
    const double below = c[1] * std::hypot(std::hypot(p.x(), p.y()), z) + (1.0 - c[1]) * z;
    return {k.fx * p.x() / below + k.cx, k.fy * p.y() / below + k.cy};
  }
  const double x = p.x() / z;
  const double y = p.y() / z;
  const double s = x * x + y * y;
  const double radial = 1.0 + c[1] * s + c[2] * s * s;
  const double u = x * radial + 2.0 * c[3] * x * y + c[4] * (s + 2.0 * x * x);
  const double v = y * radial + c[3] * (s + 2.0 * y * y) + 2.0 * c[4] * x * y;
  return {k.fx * (u + c[5] * v) + k.cx, k.fy * v + k.cy};
}

/// Where OpenCV projects a point of the optical frame.
cv::Point2d truth(const CameraModel& camera, const Eigen::Vector3d& p) {
  const Intrinsics& k = camera.intrinsics();
  const cv::Matx33d matrix(k.fx, 0, k.cx, 0, k.fy, k.cy, 0, 0, 1);
  const auto& c = camera.distortion().coefficients;
  const std::vector<cv::Point3d> points = {{p.x(), p.y(), p.z()}};
  std::vector<cv::Point2d> pixels;
  const DistortionModel model = camera.distortion().model;
  if (model == DistortionModel::kOmnidirectional || model == DistortionModel::kDoubleSphere) {
    return truthOfSpheres(camera, p);
  }
  if (camera.distortion().model == DistortionModel::kEquidistant) {
    cv::fisheye::projectPoints(points, pixels, cv::Vec3d(), cv::Vec3d(), matrix,
                               std::vector<double>(c.begin(), c.begin() + 4));
  } else {
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), matrix,
                      std::vector<double>(c.begin(), c.end()), pixels);
  }
  return pixels[0];
}

class LensRendering : public ::testing::TestWithParam<LensCase> {};

/// A small square that faces the camera, turned so that its edges cross the rows and columns of
/// pixels: edges along them would add or remove whole rows of the mask at once.
class Marker {
 public:
  Marker(const Eigen::Vector3d& direction, double distance, double half_side)
      : half_side_(half_side) {
    pose_ = makePose(distance * direction,
                     Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction) *
                         Eigen::AngleAxisd(kTurn, Eigen::Vector3d::UnitZ()));
  }

  [[nodiscard]] const Pose& pose() const { return pose_; }

  /// The square's outline as projected by OpenCV, relative to `origin` [px].
  [[nodiscard]] std::vector<cv::Point2f> outline(const CameraModel& camera,
                                                 const cv::Point2d& origin) const {
    std::vector<cv::Point2f> outline;
    constexpr int kSteps = 16;
    const double corners[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    for (int side = 0; side < 4; ++side) {
      for (int i = 0; i < kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps;
        const Eigen::Vector3d p(
            half_side_ * ((1 - t) * corners[side][0] + t * corners[side + 1][0]),
            half_side_ * ((1 - t) * corners[side][1] + t * corners[side + 1][1]), 0.0);
        outline.emplace_back(truth(camera, pose_ * p) - origin);
      }
    }
    return outline;
  }

  /// The centre of area of the projected square.
  [[nodiscard]] cv::Point2d centroid(const CameraModel& camera) const {
    const cv::Point2d origin = truth(camera, pose_.translation());
    const cv::Moments m = cv::moments(outline(camera, origin));
    return origin + cv::Point2d(m.m10 / m.m00, m.m01 / m.m00);
  }

 private:
  static constexpr double kTurn = 0.4;  // [rad]

  Pose pose_;
  double half_side_;
};

/// Directions all over what the camera sees in front of it, away from the image's edge.
std::vector<Eigen::Vector3d> directionsSeenBy(const CameraModel& camera, int count) {
  std::mt19937 random(21);
  std::vector<Eigen::Vector3d> directions;
  while (static_cast<int>(directions.size()) < count) {
    std::uniform_real_distribution<double> u(60.0, camera.width() - 61.0);
    std::uniform_real_distribution<double> v(60.0, camera.height() - 61.0);
    const Eigen::Vector2d pixel(u(random), v(random));
    const auto ray = camera.ray(pixel);
    // OpenCV's fisheye model projects only what is in front.
    if (ray && ray->z() > 0.1 && std::acos(ray->z()) < camera.largestAngle() - 0.2) {
      directions.push_back(*ray);
    }
  }
  return directions;
}

TEST_P(LensRendering, MarkersLieWhereOpenCvProjectsThem) {
  const CameraModel& camera = GetParam().camera;
  constexpr double kHalfSide = 0.1;
  constexpr int kMarkers = 12;
  Stage stage;
  stage.addBox({2 * kHalfSide, 2 * kHalfSide, 1e-6}, Pose::Identity(), 0, coloured(1, 1, 1));
  Renderer renderer(dark(), stage.links(), {});
  double worst_colour = 0.0;
  double worst_ids = 0.0;
  cv::Point2d sum_ids(0, 0);
  for (const Eigen::Vector3d& direction : directionsSeenBy(camera, kMarkers)) {
    const Marker marker(direction, 1.0, kHalfSide);
    stage.poses()[0] = marker.pose();
    const View view{camera, Pose::Identity()};
    const LabelImages labels = renderer.labels(view, stage.poses(), {stage.all()});
    const cv::Mat image = renderer.colour(view, stage.poses(), {stage.all(), stage.all()});

    const cv::Point2d expected = marker.centroid(camera);
    const cv::Moments ids = cv::moments(labels.ids == 1, true);
    ASSERT_GT(ids.m00, 30.0);
    worst_ids = std::max(
        worst_ids, std::hypot(ids.m10 / ids.m00 - expected.x, ids.m01 / ids.m00 - expected.y));
    sum_ids += cv::Point2d(ids.m10 / ids.m00, ids.m01 / ids.m00) - expected;
    cv::Mat light;
    cv::extractChannel(image, light, 1);
    light.convertTo(light, CV_32FC1, 1.0 / 255.0);
    cv::pow(light, 2.2, light);  // area is light, not encoded values
    const cv::Moments colour = cv::moments(light);
    worst_colour = std::max(worst_colour, std::hypot(colour.m10 / colour.m00 - expected.x,
                                                     colour.m01 / colour.m00 - expected.y));
  }
  RecordProperty("worst_ids", std::to_string(worst_ids));
  RecordProperty("worst_colour", std::to_string(worst_colour));
  // A mask counts whole pixels, so that its centre of area is off by chance, up to 0.2 px for these
  // markers; on average it is where it should be.
  EXPECT_LT(worst_ids, 0.2);
  EXPECT_LT(cv::norm(sum_ids) / kMarkers, 0.05);
  EXPECT_LT(worst_colour, 0.1);
}

TEST_P(LensRendering, MasksAreRightUpToHalfADrawnPixelFromTheOutline) {
  // Each pixel takes the nearest pixel of the undistorted pictures, which are twice as dense as the
  // image: it lies within half of that pixel's diagonal.
  constexpr double kNearest = 0.5 * 1.4143 / 2.0;  // [px]
  const CameraModel& camera = GetParam().camera;
  Stage stage;
  stage.addBox({0.24, 0.24, 1e-6}, Pose::Identity(), 0, coloured(1, 1, 1));
  Renderer renderer(dark(), stage.links(), {});
  int inside = 0;
  int wrong = 0;
  for (const Eigen::Vector3d& direction : directionsSeenBy(camera, 4)) {
    const Marker marker(direction, 1.0, 0.12);
    stage.poses()[0] = marker.pose();
    const LabelImages labels =
        renderer.labels({camera, Pose::Identity()}, stage.poses(), {stage.all()});
    const std::vector<cv::Point2f> outline = marker.outline(camera, {0, 0});
    for (int v = 0; v < camera.height(); ++v) {
      for (int u = 0; u < camera.width(); ++u) {
        const cv::Point2f pixel(static_cast<float>(u), static_cast<float>(v));
        const double depth_inside = cv::pointPolygonTest(outline, pixel, true);
        if (std::abs(depth_inside) <= kNearest) continue;
        inside += depth_inside > 0.0 ? 1 : 0;
        wrong += (depth_inside > 0.0) == (labels.ids.at<int>(v, u) == 1) ? 0 : 1;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(inside, 1000);
}

TEST_P(LensRendering, CentresOfColourAndLabelsAreTheSamePixels) {
  Stage stage;
  std::mt19937 random(5);
  for (const Eigen::Vector3d& direction : directionsSeenBy(GetParam().camera, 12)) {
    stage.addBox({0.3, 0.2, 0.25}, makePose(1.3 * direction, randomOrientation(random)), 0,
                 coloured(1, 1, 1));
  }
  Renderer renderer(dark(), stage.links(), {});
  const View view{GetParam().camera, Pose::Identity()};
  const LabelImages labels = renderer.labels(view, stage.poses(), {stage.all()});
  const cv::Mat image =
      renderer.colour(view, stage.poses(), {stage.all(), stage.all(), Sampling::kCentre});
  cv::Mat grey;
  cv::extractChannel(image, grey, 1);
  EXPECT_EQ(cv::norm(grey > 0, labels.ids == 1, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(labels.depth != 0, labels.ids == 1, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::countNonZero(labels.ids), 1000);
}

TEST_P(LensRendering, DepthIsThatOfThePlaneAlongEachPixelsRay) {
  const Pose X_CB =
      makePose({0, 0, 2}, Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY())));
  Stage stage;
  stage.addBox({60, 60, 1e-4}, X_CB, 0);
  Renderer renderer(dark(), stage.links(), {});
  const CameraModel& camera = GetParam().camera;
  const LabelImages labels =
      renderer.labels({camera, Pose::Identity()}, stage.poses(), {stage.all()});
  const Eigen::Vector3d normal = X_CB.linear().col(2);
  const double offset = normal.dot(X_CB.translation());
  int compared = 0;
  for (int v = 0; v < camera.height(); v += 7) {
    for (int u = 0; u < camera.width(); u += 7) {
      const auto ray = camera.ray({u, v});
      if (!ray) continue;
      const double distance = offset / normal.dot(*ray);
      if (distance <= 0.0 || (distance * *ray - X_CB.translation()).norm() > 25.0) continue;
      const double z = distance * ray->z();
      EXPECT_NEAR(labels.depth.at<float>(v, u), z, 2e-3 * std::abs(z)) << u << ", " << v;
      ++compared;
    }
  }
  EXPECT_GT(compared, 2000);
}

TEST_P(LensRendering, RegionsHaveThePixelsOfTheWholePicture) {
  Stage stage;
  stage.addBox({20, 20, 0.1}, makePose({0, 0, 3}, Eigen::Quaterniond(0.9, 0.2, 0.3, 0.1)), 0,
               coloured(0.9F, 0.4F, 0.2F));
  Renderer renderer(dark(), stage.links(), {});
  const View view{GetParam().camera, Pose::Identity()};
  ColourPass pass{stage.all(), stage.all()};
  const cv::Mat whole = renderer.colour(view, stage.poses(), pass);
  const cv::Rect region(100, 60, 300, 200);
  const cv::Rect other(500, 30, 40, 400);
  pass.regions = {region, other};
  const cv::Mat part = renderer.colour(view, stage.poses(), pass);
  EXPECT_EQ(cv::norm(whole(region), part(region), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(whole(other), part(other), cv::NORM_INF), 0.0);
  EXPECT_EQ(part.at<cv::Vec3b>(400, 320), cv::Vec3b(0, 0, 0)) << "the background's colour";
}

TEST_P(LensRendering, SamePixelsAllAroundForAnEvenRoom) {
  // A sky of one colour: no seam, no missing line, no edge may show.
  world::Description description = dark();
  description.background = {0.5F, 0.6F, 0.7F};
  Stage stage;
  stage.addBox({0.1, 0.1, 0.1}, makePose({0, 0, -50}, Eigen::Quaterniond::Identity()));
  Renderer renderer(description, stage.links(), {});
  const CameraModel& camera = GetParam().camera;
  const cv::Mat image =
      renderer.colour({camera, Pose::Identity()}, stage.poses(), {stage.all(), stage.all()});
  const cv::Vec3b sky = image.at<cv::Vec3b>(camera.height() / 2, camera.width() / 2);
  EXPECT_NEAR(sky[0], 0.7 * 255, 1.0);
  for (int v = 0; v < camera.height(); ++v) {
    for (int u = 0; u < camera.width(); ++u) {
      const cv::Vec3b expected = camera.ray({u, v}) ? sky : cv::Vec3b(0, 0, 0);
      ASSERT_EQ(image.at<cv::Vec3b>(v, u), expected) << u << ", " << v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses, LensRendering,
                         ::testing::Values(kPlumbBob, kRational, kFisheye170, kFisheye190,
                                           test::kTiltedPrism, test::kOmnidirectional,
                                           test::kDoubleSphere),
                         [](const auto& lens) { return std::string(lens.param.name); });

TEST(LensRenderer, SeesWhatIsNearBesideAWideLens) {
  // 0.06 m away, half-way between two sides of the cube: nearer than `near` along either axis.
  const CameraModel camera(600, 600, {180, 180, 299.5, 299.5}, 0.05, 100.0,
                           {DistortionModel::kEquidistant, {}});
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 1, 1).normalized();
  Stage stage;
  stage.addBox({0.02, 0.02, 1e-4},
               makePose(0.06 * direction,
                        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction)),
               0);
  Renderer renderer(dark(), stage.links(), {});
  const cv::Mat ids = renderer.labels({camera, Pose::Identity()}, stage.poses(), {stage.all()}).ids;
  const Eigen::Vector2d pixel = *camera.project(0.06 * direction);
  EXPECT_EQ(ids.at<int>(static_cast<int>(pixel.y()), static_cast<int>(pixel.x())), 1);
}

TEST(LensRenderer, DrawsWhatIsAllAroundInAHandfulOfPixels) {
  // Neighbours of a pixel look to other sides of the cube, and at right angles to one another.
  world::Description grey = dark();
  grey.ambient = {0.5F, 0.5F, 0.5F};
  Stage stage;
  stage.addBox({20, 20, 0.1}, makePose({0, 0, 3}, Eigen::Quaterniond::Identity()), -1,
               coloured(1, 1, 1));
  Renderer renderer(grey, stage.links(), {});
  const auto middle = [&](const CameraModel& camera) -> int {
    return renderer.colour({camera, Pose::Identity()}, stage.poses(), {stage.all(), stage.all()})
        .at<cv::Vec3b>(24, 32)[1];
  };
  const int expected = middle({65, 49, {50, 50, 32.0, 24.0}, 0.05, 100.0});
  ASSERT_GT(expected, 50);
  for (const auto& distortion : {Distortion{DistortionModel::kPlumbBob, {0.05}},
                                 Distortion{DistortionModel::kEquidistant, {0.0}}}) {
    for (const double f : {0.2, 0.676, 1.0}) {
      EXPECT_NEAR(middle({65, 49, {f, f, 32.0, 24.0}, 0.05, 100.0, distortion}), expected, 1) << f;
    }
  }
}

TEST(LensRenderer, ExposureMultipliesTheLight) {
  world::Description description = dark();
  description.ambient = {0.4F, 0.4F, 0.4F};
  Stage stage;
  stage.addBox({20, 20, 0.1}, makePose({0, 0, 3}, Eigen::Quaterniond::Identity()), -1,
               coloured(0.6F, 0.6F, 0.6F));
  Renderer renderer(description, stage.links(), {});
  const View view{kPlumbBob.camera, Pose::Identity()};
  ColourPass pass{stage.all(), stage.all()};
  const auto light = [&] {
    const int value = renderer.colour(view, stage.poses(), pass).at<cv::Vec3b>(240, 320)[1];
    return std::pow((value / 255.0 + 0.055) / 1.055, 2.4);
  };
  const double once = light();
  pass.exposure = 4.0F;
  EXPECT_NEAR(light() / once, 4.0, 0.15);
}

}  // namespace lens_test
}  // namespace synthetic_dataset::render

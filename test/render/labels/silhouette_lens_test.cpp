#include <cmath>

#include <gtest/gtest.h>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"

namespace synthetic_dataset::render {
namespace silhouette_lens_test {

using synthetic_dataset::test::Stage;

/// A smaller camera with the same lens.
CameraModel scaled(const CameraModel& camera, double scale) {
  const Intrinsics& k = camera.intrinsics();
  return {static_cast<int>(camera.width() * scale),
          static_cast<int>(camera.height() * scale),
          {k.fx * scale, k.fy * scale, k.cx * scale, k.cy * scale},
          camera.near(),
          camera.far(),
          camera.distortion()};
}

/// A board that is seen from one side, with a test for rays that hit it.
struct Board {
  Pose X_CB;
  double half_width;
  double half_height;

  [[nodiscard]] Stage stage() const {
    Stage result;
    constexpr double kThickness = 1e-4;
    result.addBox({2 * half_width, 2 * half_height, kThickness},
                  X_CB * Eigen::Translation3d(0, 0, 0.5 * kThickness), 0);
    return result;
  }

  [[nodiscard]] bool isHitBy(const Eigen::Vector3d& ray_C) const {
    const Eigen::Vector3d origin = X_CB.inverse().translation();
    const Eigen::Vector3d ray = X_CB.linear().transpose() * ray_C;
    const double distance = -origin.z() / ray.z();
    const Eigen::Vector3d hit = origin + distance * ray;
    return distance > 0.0 && std::abs(hit.x()) < half_width && std::abs(hit.y()) < half_height;
  }
};

struct Counts {
  int all = 0;
  int in_image = 0;
};

/// Counts the pixels that see the board, up to an image's width and height outside of the image.
Counts pixelsThatSee(const Board& board, const CameraModel& camera) {
  Counts counts;
  const int width = camera.width();
  const int height = camera.height();
  for (int v = -height; v < 2 * height; ++v) {
    for (int u = -width; u < 2 * width; ++u) {
      const auto ray = camera.ray({u, v});
      if (!ray || !board.isHitBy(*ray)) continue;
      ++counts.all;
      if (u >= 0 && v >= 0 && u < width && v < height) ++counts.in_image;
    }
  }
  return counts;
}

/// A board that faces the camera from a distance, at an angle about y from the optical axis.
Board boardAt(double angle, double distance, double half_width, double half_height) {
  const Pose turn =
      makePose({0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY())));
  return {turn * Eigen::Translation3d(0, 0, distance), half_width, half_height};
}

class SilhouetteThroughALens : public ::testing::TestWithParam<test::LensCase> {};

TEST_P(SilhouetteThroughALens, IsWhatLabelsShowOfTheObjectAlone) {
  const CameraModel camera = scaled(GetParam().camera, 0.5);
  for (const double angle : {0.1, 0.45, -0.6}) {
    const Stage stage = boardAt(angle, 2.0, 0.6, 0.4).stage();
    Renderer renderer({}, stage.links(), {});
    const View view{camera, Pose::Identity()};

    const Silhouette silhouette = renderer.silhouette(view, stage.poses(), stage.all());
    const cv::Mat labels = renderer.labels(view, stage.poses(), {stage.all()}).ids > 0;

    EXPECT_GT(silhouette.pixels_in_image, 0);
    EXPECT_EQ(cv::norm(silhouette.mask.whole(), labels, cv::NORM_INF), 0.0) << angle;
  }
}

TEST_P(SilhouetteThroughALens, GoesOnPastTheImagesEdge) {
  const CameraModel camera = scaled(GetParam().camera, 0.25);
  // Its middle lies on the edge of the image.
  const auto edge = camera.ray({camera.width() - 0.5, camera.intrinsics().cy});
  const double edge_angle = edge ? std::atan2(edge->x(), edge->z()) : camera.largestAngle();
  const Board board = boardAt(edge_angle, 2.0, 0.3, 0.4);
  const Stage stage = board.stage();
  Renderer renderer({}, stage.links(), {});

  const Silhouette silhouette =
      renderer.silhouette({camera, Pose::Identity()}, stage.poses(), stage.all());

  // The ray of a pixel at the outline may be off by a quarter of a pixel.
  const Counts wanted = pixelsThatSee(board, camera);
  EXPECT_GT(wanted.in_image, 50);
  EXPECT_NEAR(static_cast<double>(silhouette.pixels_in_image), wanted.in_image,
              0.04 * wanted.in_image + 2);
  EXPECT_NEAR(static_cast<double>(silhouette.pixels), wanted.all, 0.04 * wanted.all + 2);
}

TEST_P(SilhouetteThroughALens, FillsAllThatTheLensSeesFromInsideOfABox) {
  const CameraModel camera = scaled(GetParam().camera, 0.25);
  world::Material wall;
  wall.double_sided = true;
  Stage stage;
  stage.addBox({2, 2, 2}, Pose::Identity(), 0, wall);
  Renderer renderer({}, stage.links(), {});

  const Silhouette silhouette =
      renderer.silhouette({camera, Pose::Identity()}, stage.poses(), stage.all());

  int wanted = 0;
  for (int v = -camera.height(); v < 2 * camera.height(); ++v) {
    for (int u = -camera.width(); u < 2 * camera.width(); ++u) {
      const auto ray = camera.ray({u, v});
      if (!ray) continue;
      const bool behind_near_plane =
          camera.hasNearPlane() && ray->z() < camera.near() * ray->cwiseAbs().maxCoeff();
      if (!behind_near_plane) ++wanted;
    }
  }
  EXPECT_NEAR(static_cast<double>(silhouette.pixels), wanted, 0.005 * wanted);
}

TEST_P(SilhouetteThroughALens, IsNothingBesideWhatTheLensSees) {
  const CameraModel camera = scaled(GetParam().camera, 0.25);
  const Stage stage = boardAt(camera.largestAngle() + 0.3, 2.0, 0.2, 0.2).stage();
  Renderer renderer({}, stage.links(), {});

  const Silhouette silhouette =
      renderer.silhouette({camera, Pose::Identity()}, stage.poses(), stage.all());

  EXPECT_EQ(silhouette.pixels, 0);
  EXPECT_FALSE(silhouette.box);
}

INSTANTIATE_TEST_SUITE_P(Lenses, SilhouetteThroughALens,
                         ::testing::Values(test::kPlumbBob, test::kRational, test::kFisheye170,
                                           test::kFisheye190, test::kOmnidirectional,
                                           test::kDoubleSphere),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(SilhouetteThroughALargeLens, CountsCellsBesideTheImageByTheirArea) {
  // Not every pixel of an area of 3 x 3 such images is drawn.
  const CameraModel camera = scaled(test::kPlumbBob.camera, 1.4);
  const auto edge = camera.ray({camera.width() - 0.5, camera.intrinsics().cy});
  const Board board = boardAt(std::atan2(edge->x(), edge->z()), 2.0, 0.1, 0.2);
  const Stage stage = board.stage();
  Renderer renderer({}, stage.links(), {});

  const Silhouette silhouette =
      renderer.silhouette({camera, Pose::Identity()}, stage.poses(), stage.all());

  int wanted = 0;
  for (int v = 0; v < camera.height(); ++v) {
    for (int u = camera.width() / 2; u < 2 * camera.width(); ++u) {
      const auto ray = camera.ray({u, v});
      if (ray && board.isHitBy(*ray)) ++wanted;
    }
  }
  EXPECT_NEAR(static_cast<double>(silhouette.pixels), wanted, 0.01 * wanted);
  EXPECT_GT(silhouette.box->right, camera.width());
  EXPECT_NEAR(silhouette.box->right,
              camera
                  .projectedBounds({board.X_CB * Eigen::Vector3d(0.1, -0.2, 0),
                                    board.X_CB * Eigen::Vector3d(0.1, 0.2, 0),
                                    board.X_CB * Eigen::Vector3d(-0.1, -0.2, 0),
                                    board.X_CB * Eigen::Vector3d(-0.1, 0.2, 0)})
                  ->right,
              2.5);
}

}  // namespace silhouette_lens_test
}  // namespace synthetic_dataset::render

/// Labels against ray casts, which find what a pixel shows without drawing.

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "support/random_poses.h"
#include "synthetic_dataset/mask.h"
#include "world/physics/ray_caster.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace ray_casting_test {

using synthetic_dataset::test::randomOrientation;
using synthetic_dataset::test::randomPoint;
using synthetic_dataset::test::Stage;
using world::RayCaster;
using world::RayHit;

constexpr double kRange = 90.0;

/// Triangles anywhere in a cube, each with its own corners and normal.
std::shared_ptr<const world::Mesh> triangleSoup(std::mt19937& random, int count) {
  auto mesh = std::make_shared<world::Mesh>();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d a = randomPoint(random, 0.6);
    const Eigen::Vector3d b = a + randomPoint(random, 0.5);
    const Eigen::Vector3d c = a + randomPoint(random, 0.5);
    for (const Eigen::Vector3d& corner : {a, b, c}) {
      mesh->indices.push_back(static_cast<std::uint32_t>(mesh->positions.size()));
      mesh->positions.emplace_back(corner.cast<float>());
      mesh->normals.emplace_back((b - a).cross(c - a).normalized().cast<float>());
    }
  }
  return mesh;
}

/// Things of all shapes in a cube of 4 m, some of them inside one another; every third one belongs
/// to no object.
struct RandomWorld {
  explicit RandomWorld(std::mt19937& random) {
    world::Material surface;
    surface.double_sided = true;  // rays hit both sides
    std::uniform_real_distribution<double> size(0.2, 1.2);
    constexpr int kThings = 16;
    for (int i = 0; i < kThings; ++i) {
      std::shared_ptr<const world::Mesh> mesh;
      if (i % 4 == 0) mesh = world::boxMesh({size(random), size(random), size(random)});
      if (i % 4 == 1) mesh = world::sphereMesh(0.5 * size(random));
      if (i % 4 == 2) mesh = world::cylinderMesh(0.4 * size(random), size(random));
      if (i % 4 == 3) mesh = triangleSoup(random, 20);
      is_flat.push_back(i % 4 == 0 || i % 4 == 3);
      stage.addMesh(mesh, makePose(randomPoint(random, 2.0), randomOrientation(random)),
                    i % 3 == 0 ? -1 : i, surface);
    }
  }

  Stage stage;
  std::vector<bool> is_flat;  ///< whether a link's normals are those of its triangles
};

/// A camera that looks roughly at the middle of the world from a distance [m].
Pose randomView(std::mt19937& random, double distance) {
  const Pose X_WD = makePose(randomPoint(random, 0.5), randomOrientation(random));
  return X_WD * Eigen::Translation3d(0, 0, -distance);
}

/// What one ray hits, in the camera's frame.
struct Sight {
  int id = 0;
  int link = 0;
  double range = 0.0;
  Eigen::Vector3d ray_C = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();

  [[nodiscard]] double depth() const { return range * ray_C.z(); }
};

class Caster {
 public:
  Caster(const Stage& stage, const View& view)
      : stage_(stage), view_(view), rays_(stage.links(), stage.poses()) {}

  /// Returns nothing for pixels at which the lens sees nothing.
  [[nodiscard]] std::optional<Sight> look(const Eigen::Vector2d& pixel) const {
    const auto ray_C = view_.camera.ray(pixel);
    if (!ray_C) return std::nullopt;
    Sight sight;
    sight.ray_C = *ray_C;
    const auto hit = rays_.cast(view_.X_WC.translation(), view_.X_WC.linear() * *ray_C, kRange);
    if (!hit) return sight;
    sight.link = static_cast<int>(hit->link) + 1;
    sight.id = stage_.links()[hit->link].object + 1;
    sight.range = hit->distance;
    sight.normal_C = view_.X_WC.linear().transpose() * hit->normal_W;
    return sight;
  }

  /// Whether another link, or another face of the same, is within a small step of the pixel.
  [[nodiscard]] bool isEdge(const Eigen::Vector2d& pixel, double step) const {
    const auto here = look(pixel);
    for (int i = 0; i < 25; ++i) {
      const Eigen::Vector2d to = 0.5 * step * Eigen::Vector2d(i % 5 - 2, i / 5 - 2);
      const auto there = look(pixel + to);
      if (!there || there->link != here->link) return true;
      if (here->link == 0) continue;
      constexpr double kCrease = 0.9;  // cosine of the angle between two faces
      if (there->normal_C.dot(here->normal_C) < kCrease) return true;
      // The range of the neighbouring ray if the surface were flat.
      const double flat =
          here->range * here->normal_C.dot(here->ray_C) / here->normal_C.dot(there->ray_C);
      if (!(std::abs(there->range - flat) < tolerance(here->range))) return true;
    }
    return false;
  }

  /// 1 mm at 5 m.
  static double tolerance(double range) { return 2e-4 * range; }

 private:
  const Stage& stage_;
  const View& view_;
  RayCaster rays_;
};

struct Agreement {
  int rays = 0;
  int hits = 0;
  int edges = 0;  ///< disagree, at an edge
  int wrong = 0;  ///< disagree, not at an edge
};

bool agrees(const Sight& sight, const LabelImages& labels, int v, int u, bool is_flat) {
  if (sight.id != labels.ids.at<int>(v, u) || sight.link != labels.links.at<int>(v, u)) {
    return false;
  }
  if (sight.link == 0) return true;
  const double tolerance = Caster::tolerance(sight.range);
  const auto& n = labels.normals.at<cv::Vec3f>(v, u);
  const bool turned = is_flat && Eigen::Vector3f(n.val).cast<double>().dot(sight.normal_C) < 0.9999;
  return !turned &&
         std::abs(static_cast<double>(labels.depth.at<float>(v, u)) - sight.depth()) < tolerance &&
         std::abs(static_cast<double>(labels.range.at<float>(v, u)) - sight.range) < tolerance;
}

/// Casts rays through random pixels of random worlds.
/// @param edge_step  [px] how far from its centre a pixel may have been sampled
/// @param distance  [m] from the camera to the middle of the world, more or less
Agreement castRays(const CameraModel& camera, unsigned seed, double distance, int worlds, int rays,
                   double edge_step) {
  Agreement agreement;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> column(0, camera.width() - 1);
  std::uniform_int_distribution<int> row(0, camera.height() - 1);
  for (int i = 0; i < worlds; ++i) {
    const RandomWorld world(random);
    const View view{camera, randomView(random, distance)};
    Renderer renderer({}, world.stage.links(), {});
    const LabelImages labels =
        renderer.labels(view, world.stage.poses(), {world.stage.all(), true, true, true});
    const Caster caster(world.stage, view);
    for (int j = 0; j < rays; ++j) {
      const int u = column(random);
      const int v = row(random);
      const auto sight = caster.look({u, v});
      if (!sight) continue;
      ++agreement.rays;
      const bool hit = sight->link > 0;
      if (hit) ++agreement.hits;
      const bool flat = hit && world.is_flat[static_cast<std::size_t>(sight->link - 1)];
      if (agrees(*sight, labels, v, u, flat)) continue;
      ++(caster.isEdge({u, v}, edge_step) ? agreement.edges : agreement.wrong);
    }
  }
  return agreement;
}

TEST(RayCasting, FindsWhatAPinholeCamerasLabelsSay) {
  const CameraModel camera(640, 480, {554.38, 560.1, 321.7, 238.2}, 0.05, 100.0);

  const Agreement agreement = castRays(camera, 11, 5.0, 20, 5000, 0.02);

  EXPECT_EQ(agreement.rays, 100000);
  EXPECT_GT(agreement.hits, 20000);
  EXPECT_EQ(agreement.wrong, 0);
  EXPECT_LT(agreement.edges, 100) << "one in a thousand";
}

/// Casts each pixel's own ray, through any lens.
class LensRays : public ::testing::TestWithParam<test::LensCase> {};

TEST_P(LensRays, SeeWhatLabelsSay) {
  const Agreement agreement = castRays(GetParam().camera, 12, 3.0, 6, 20000, 0.01);

  EXPECT_GT(agreement.hits, 10000);
  EXPECT_EQ(agreement.wrong, 0);
  EXPECT_LT(agreement.edges, agreement.rays / 1000) << "of " << agreement.rays;
}

INSTANTIATE_TEST_SUITE_P(RayCasting, LensRays,
                         ::testing::Values(test::kPlumbBob, test::kTiltedPrism, test::kFisheye190,
                                           test::kOmnidirectional),
                         [](const auto& each) { return std::string(each.param.name); });

/// The pixels that see a link, in the image and in an area of its size on each side.
struct CastSilhouette {
  cv::Mat hits;   ///< of three times the image's size, the image in its middle
  cv::Mat edges;  ///< pixels whose centre is so near to an edge that either answer is right
};

CastSilhouette castSilhouette(const RayCaster& caster, const View& view) {
  const int width = view.camera.width();
  const int height = view.camera.height();
  const auto hits = [&](double u, double v) {
    const auto ray_C = view.camera.ray({u, v});
    return caster.cast(view.X_WC.translation(), view.X_WC.linear() * *ray_C, kRange).has_value();
  };
  CastSilhouette result{cv::Mat::zeros(3 * height, 3 * width, CV_8UC1),
                        cv::Mat::zeros(3 * height, 3 * width, CV_8UC1)};
  for (int v = 0; v < 3 * height; ++v) {
    for (int u = 0; u < 3 * width; ++u) {
      if (hits(u - width, v - height)) result.hits.at<unsigned char>(v, u) = 255;
    }
  }
  constexpr double kStep = 0.02;  // [px]
  cv::Mat about;
  cv::morphologyEx(result.hits, about, cv::MORPH_GRADIENT, cv::Mat::ones(3, 3, CV_8UC1));
  for (int v = 0; v < 3 * height; ++v) {
    for (int u = 0; u < 3 * width; ++u) {
      if (about.at<unsigned char>(v, u) == 0) continue;
      const bool here = result.hits.at<unsigned char>(v, u) != 0;
      for (const auto& [du, dv] :
           {std::pair{kStep, 0.0}, {-kStep, 0.0}, {0.0, kStep}, {0.0, -kStep}}) {
        if (hits(u - width + du, v - height + dv) != here) {
          result.edges.at<unsigned char>(v, u) = 255;
        }
      }
    }
  }
  return result;
}

Box boxOf(const cv::Mat& pixels, const CameraModel& camera) {
  const cv::Rect r = maskBounds(pixels);
  const double left = r.x - camera.width() - 0.5;
  const double top = r.y - camera.height() - 0.5;
  return {left, top, left + r.width, top + r.height};
}

bool isWithin(const Box& inner, const Box& outer) {
  return inner.left >= outer.left && inner.top >= outer.top && inner.right <= outer.right &&
         inner.bottom <= outer.bottom;
}

TEST(RayCasting, FindsTheSilhouettesBoxes) {
  const CameraModel camera(64, 48, {60.0, 61.0, 31.7, 23.2}, 0.05, 100.0);
  std::mt19937 random(14);
  const RandomWorld world(random);
  View view{camera, randomView(random, 4.0)};
  view.X_WC = view.X_WC * Eigen::Translation3d(1.2, 0.8, 0.0);
  Renderer renderer({}, world.stage.links(), {});
  int beyond = 0;
  int exact = 0;
  for (std::size_t i = 0; i < world.stage.links().size(); ++i) {
    LinkSelection alone(world.stage.links().size(), false);
    alone[i] = true;
    const RayCaster caster({world.stage.links()[i]}, {world.stage.poses()[i]});
    const CastSilhouette wanted = castSilhouette(caster, view);
    const cv::Mat least = wanted.hits & ~wanted.edges;
    const cv::Mat most = wanted.hits | wanted.edges;
    ASSERT_GT(cv::countNonZero(least), 0) << i;

    const Silhouette silhouette = renderer.silhouette(view, world.stage.poses(), alone);

    EXPECT_GE(silhouette.pixels, cv::countNonZero(least)) << i;
    ASSERT_TRUE(silhouette.box) << i;
    const Box all = boxOf(cv::Mat(most.size(), CV_8UC1, cv::Scalar(255)), camera);
    if (!isWithin(*silhouette.box, all)) continue;  // farther out than rays were cast
    EXPECT_LE(silhouette.pixels, cv::countNonZero(most)) << i;
    EXPECT_TRUE(isWithin(boxOf(least, camera), *silhouette.box)) << i;
    EXPECT_TRUE(isWithin(*silhouette.box, boxOf(most, camera))) << i;
    if (silhouette.pixels_in_image < silhouette.pixels) ++beyond;
    if (silhouette.pixels == cv::countNonZero(wanted.hits)) ++exact;
  }
  EXPECT_GT(beyond, 2);
  EXPECT_GT(exact, 8) << "of " << world.stage.links().size();
}

}  // namespace ray_casting_test
}  // namespace synthetic_dataset::render

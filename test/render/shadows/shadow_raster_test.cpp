#include "render/shadows/shadow_raster.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "support/random_poses.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace shadow_raster_test {

constexpr int kSize = 96;

/// A random rotation, at this many texels per metre.
Eigen::Affine3f placed(std::mt19937& random, double texels, const Eigen::Vector2d& middle) {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() = Eigen::Vector3d(texels, texels, 0.2).asDiagonal() *
                 test::randomOrientation(random).toRotationMatrix();
  map.translation() << middle, 0.5;
  return map.cast<float>();
}

cv::Mat whole(const std::optional<MapPiece>& piece, int size = kSize) {
  cv::Mat map(size, size, CV_32FC1, cv::Scalar(1.0));
  if (piece) piece->depths.copyTo(map(piece->texels));
  return map;
}

/// The least depth of all triangles at each texel's centre; `clear` tells how far it is from the
/// next side of one [texel].
cv::Mat leastDepths(const world::Mesh& mesh, const Eigen::Affine3f& map_from_mesh, cv::Mat& clear) {
  cv::Mat depths(kSize, kSize, CV_64FC1, cv::Scalar(1.0));
  clear = cv::Mat(kSize, kSize, CV_64FC1, cv::Scalar(1e9));
  const Eigen::Affine3d map = map_from_mesh.cast<double>();
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) {
      corners.col(k) =
          map * mesh.positions[mesh.indices[i + static_cast<std::size_t>(k)]].cast<double>();
    }
    Eigen::Matrix3d places = corners;
    places.row(2).setOnes();
    if (std::abs(places.determinant()) < 1e-9) continue;
    const Eigen::Matrix3d shares = places.inverse();
    for (int v = 0; v < kSize; ++v) {
      for (int u = 0; u < kSize; ++u) {
        const Eigen::Vector3d share = shares * Eigen::Vector3d(u + 0.5, v + 0.5, 1.0);
        for (int k = 0; k < 3; ++k) {  // a share grows by the length of its row per texel
          const double off = std::abs(share[k]) / shares.row(k).head<2>().norm();
          if (share.minCoeff() > -0.5)
            clear.at<double>(v, u) = std::min(clear.at<double>(v, u), off);
        }
        if (share.minCoeff() < 0.0) continue;
        depths.at<double>(v, u) = std::min(depths.at<double>(v, u), corners.row(2).dot(share));
      }
    }
  }
  return depths;
}

TEST(ShadowRaster, HasTheLeastDepthAtTheCentreOfEachTexel) {
  std::mt19937 random(3);
  for (const auto& mesh : {world::sphereMesh(0.4), world::boxMesh({0.3, 0.5, 0.7})}) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Affine3f map = placed(random, 60.0, {45.3, 50.7});
      cv::Mat clear;
      const cv::Mat wanted = leastDepths(*mesh, map, clear);
      const cv::Mat found = whole(castPiece({mesh.get(), Eigen::Projective3f(map), false}, kSize));
      int compared = 0;
      for (int v = 0; v < kSize; ++v) {
        for (int u = 0; u < kSize; ++u) {
          if (clear.at<double>(v, u) < 0.01) continue;  // corners are rounded by less
          compared += wanted.at<double>(v, u) < 1.0 ? 1 : 0;
          EXPECT_NEAR(found.at<float>(v, u), wanted.at<double>(v, u), 1e-3) << u << ", " << v;
        }
      }
      EXPECT_GT(compared, 500);
    }
  }
}

/// Compares the depths of a triangle in a spot light with where the ray of each texel meets it.
TEST(ShadowRaster, OfALampHasThePerspectiveOfItsPlace) {
  world::Mesh mesh;
  mesh.positions = {{-0.5F, -0.4F, 2.0F}, {0.6F, -0.3F, 4.0F}, {0.1F, 0.7F, 3.0F}};
  mesh.indices = {0, 1, 2};
  constexpr double kFocal = 100.0;  // [texel]
  constexpr double kNear = 0.5;
  constexpr double kFar = 10.0;
  Eigen::Projective3d map = Eigen::Projective3d::Identity();
  map.matrix() << kFocal, 0.0, 48.0, 0.0,                               //
      0.0, kFocal, 48.0, 0.0,                                           //
      0.0, 0.0, kFar / (kFar - kNear), -kFar * kNear / (kFar - kNear),  //
      0.0, 0.0, 1.0, 0.0;
  const cv::Mat found =
      whole(castPiece({&mesh, Eigen::Projective3f(map.cast<float>()), false}, kSize));
  const Eigen::Vector3d a = mesh.positions[0].cast<double>();
  const Eigen::Vector3d normal =
      (mesh.positions[1].cast<double>() - a).cross(mesh.positions[2].cast<double>() - a);
  int covered = 0;
  for (int v = 0; v < kSize; ++v) {
    for (int u = 0; u < kSize; ++u) {
      if (!(found.at<float>(v, u) < 1.0F)) continue;
      ++covered;
      const Eigen::Vector3d ray((u + 0.5 - 48.0) / kFocal, (v + 0.5 - 48.0) / kFocal, 1.0);
      const double distance = normal.dot(a) / normal.dot(ray);
      EXPECT_NEAR(found.at<float>(v, u),
                  (map.matrix() * (distance * ray).homogeneous()).hnormalized().z(), 1e-4)
          << u << ", " << v;
    }
  }
  EXPECT_NEAR(covered, 690, 15) << "the area of the projected triangle [texel]";
}

TEST(ShadowRaster, LeavesNoGapsBetweenTriangles) {
  std::mt19937 random(5);
  const auto ball = world::sphereMesh(0.4);
  for (int i = 0; i < 20; ++i) {
    const cv::Mat map = whole(
        castPiece({ball.get(), Eigen::Projective3f(placed(random, 70.0, {48, 48})), true}, kSize));
    for (int v = 0; v < kSize; ++v) {
      int changes = 0;
      for (int u = 1; u < kSize; ++u) {
        changes += (map.at<float>(v, u) < 1.0F) != (map.at<float>(v, u - 1) < 1.0F) ? 1 : 0;
      }
      EXPECT_LE(changes, 2) << "row " << v;
    }
  }
}

/// Long slivers that meet anywhere in the map.
TEST(ShadowRaster, LeavesNoGapsBetweenLargeTriangles) {
  constexpr int kLarge = 700;
  constexpr std::uint32_t kCount = 97;
  world::Mesh fan;
  fan.positions.emplace_back(311.3F, 402.7F, 0.5F);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const float angle = 2.0F * static_cast<float>(CV_PI) * static_cast<float>(i) / kCount;
    fan.positions.emplace_back(311.0F + 1500.0F * std::cos(angle),
                               402.0F + 1500.0F * std::sin(angle), 0.5F);
    fan.indices.insert(fan.indices.end(), {0, 1 + i, 1 + (i + 1) % kCount});
  }
  const CastBody body{&fan, Eigen::Projective3f::Identity(), false};
  EXPECT_EQ(cv::countNonZero(castMap({body}, kLarge) == 0.5F), kLarge * kLarge);
}

TEST(ShadowRaster, DrawsAMapAsThePiecesOfItsBodies) {
  std::mt19937 random(11);
  constexpr int kLarge = 300;  // of several bands
  std::vector<std::shared_ptr<const world::Mesh>> meshes;
  std::vector<CastBody> bodies;
  cv::Mat wanted(kLarge, kLarge, CV_32FC1, cv::Scalar(1.0));
  for (int i = 0; i < 12; ++i) {
    meshes.push_back(i % 2 == 0 ? world::sphereMesh(0.4) : world::boxMesh({0.3, 0.9, 2.0}));
    const Eigen::Vector2d middle(25.0 * i, 290.0 - 26.0 * i);
    bodies.push_back(
        {meshes.back().get(), Eigen::Projective3f(placed(random, 90.0, middle)), i % 2 == 0});
    const auto piece = castPiece(bodies.back(), kLarge);
    ASSERT_TRUE(piece);
    cv::Mat here = wanted(piece->texels);
    cv::min(here, piece->depths, here);
  }
  EXPECT_EQ(cv::norm(castMap(bodies, kLarge), wanted, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::countNonZero(wanted < 1.0F), 20000);
}

TEST(ShadowRaster, NeedsNoBacksOfABody) {
  std::mt19937 random(7);
  for (const auto& mesh : {world::sphereMesh(0.4), world::capsuleMesh(0.2, 0.5)}) {
    const Eigen::Affine3f map = placed(random, 60.0, {48, 48});
    const cv::Mat fronts = whole(castPiece({mesh.get(), Eigen::Projective3f(map), true}, kSize));
    EXPECT_LT(
        cv::norm(fronts, whole(castPiece({mesh.get(), Eigen::Projective3f(map), false}, kSize)),
                 cv::NORM_INF),
        1e-6);
    EXPECT_GT(cv::countNonZero(fronts < 1.0F), 500);
  }
}

TEST(ShadowRaster, IsCutAtTheEdgesOfTheMap) {
  std::mt19937 random(9);
  const auto ball = world::sphereMesh(0.4);
  const Eigen::Affine3f map = placed(random, 60.0, {48, 48});
  const cv::Mat all = whole(castPiece({ball.get(), Eigen::Projective3f(map), false}, kSize));
  for (const Eigen::Vector2f& shift :
       {Eigen::Vector2f(40, 0), {-40, 0}, {0, 40}, {0, -40}, {-45, 44}}) {
    Eigen::Affine3f shifted = map;
    shifted.translation().head<2>() += shift;
    const auto piece = castPiece({ball.get(), Eigen::Projective3f(shifted), false}, kSize);
    ASSERT_TRUE(piece);
    EXPECT_EQ(piece->texels & cv::Rect(0, 0, kSize, kSize), piece->texels);
    const cv::Mat found = whole(piece);
    const auto dx = static_cast<int>(shift.x());
    const auto dy = static_cast<int>(shift.y());
    const cv::Rect there = cv::Rect(dx, dy, kSize, kSize) & cv::Rect(0, 0, kSize, kSize);
    EXPECT_LT(cv::norm(found(there), all(there - cv::Point(dx, dy)), cv::NORM_INF), 1e-5);
  }
  Eigen::Affine3f beside = map;
  beside.translation().x() += 200.0F;
  EXPECT_FALSE(castPiece({ball.get(), Eigen::Projective3f(beside), false}, kSize));
}

TEST(ShadowRaster, CountsWhatLiesBeforeTheMapAsAtItsBeginning) {
  std::mt19937 random(9);
  Eigen::Affine3f map = placed(random, 60.0, {48, 48});
  map.translation().z() = -3.0F;
  const auto piece =
      castPiece({world::sphereMesh(0.4).get(), Eigen::Projective3f(map), true}, kSize);
  ASSERT_TRUE(piece);
  EXPECT_EQ(piece->depths.at<float>(piece->depths.rows / 2, piece->depths.cols / 2), 0.0F);
}

}  // namespace shadow_raster_test
}  // namespace synthetic_dataset::render

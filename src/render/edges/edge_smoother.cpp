#include "render/edges/edge_smoother.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "render/edges/edge_pixels.h"
#include "render/edges/sample_raster.h"
#include "render/pixels/half.h"
#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// Finds the light of what a pixel's samples see, at pixels whose centres see the same surface.
class Resolver {
 public:
  Resolver(const SeenPixels& seen, const SampleRaster& raster) : seen_(seen), raster_(raster) {}

  /// The mean of the samples' light.
  /// @param number  of the pixel in the raster
  [[nodiscard]] Eigen::Vector3f light(const cv::Point& pixel, std::size_t number) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    Likeness likeness;
    for (std::size_t sample = 0; sample < kSampleCount; ++sample) {
      const SeenFace* face = raster_.at(number, sample);
      if (sample == 0 || face != likeness.face) likeness = likenessOf(face, pixel);
      sum += lightAt(likeness.sees_at_centre ? pixel : pixel + nearest(likeness, sample));
    }
    return sum / static_cast<float>(kSampleCount);
  }

 private:
  static constexpr int kSide = 3;         ///< [px] of the square that is looked at
  static constexpr float kAlike = 0.01F;  ///< then its own centre is the nearest there is
  static constexpr float kAway = 0.02F;   ///< what a pixel away counts, against a turn of a radian
  static constexpr float kDepth = 10.0F;  ///< what depth counts: a share of it

  /// How little the pixels round one look like a face.
  struct Likeness {
    const SeenFace* face = nullptr;
    bool sees_at_centre = false;
    std::array<float, kSide * kSide> unlike{};  ///< row by row
  };

  [[nodiscard]] Likeness likenessOf(const SeenFace* face, const cv::Point& pixel) const {
    Likeness result{face, unlikeness(face, pixel) < kAlike, {}};
    if (result.sees_at_centre) return result;
    for (int i = 0; i < kSide * kSide; ++i) {
      const cv::Point other = pixel + offset(i);
      result.unlike[static_cast<std::size_t>(i)] = seen_.place.contains(other)
                                                       ? unlikeness(face, other)
                                                       : std::numeric_limits<float>::infinity();
    }
    return result;
  }

  [[nodiscard]] static cv::Point nearest(const Likeness& likeness, std::size_t sample) {
    cv::Point best(0, 0);
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < kSide * kSide; ++i) {
      const cv::Point away = offset(i);
      const float x = static_cast<float>(away.x) - kSampleColumns[sample];
      const float y = static_cast<float>(away.y) - kSampleRows[sample];
      const float unlike = likeness.unlike[static_cast<std::size_t>(i)] + kAway * (x * x + y * y);
      if (!(unlike < least)) continue;
      least = unlike;
      best = away;
    }
    return best;
  }

  [[nodiscard]] static cv::Point offset(int i) { return {i % kSide - 1, i / kSide - 1}; }

  /// Infinite for another surface.
  [[nodiscard]] float unlikeness(const SeenFace* face, const cv::Point& pixel) const {
    const cv::Point at = pixel - seen_.place.tl();
    const int part = seen_.geometry.parts.at<int>(at);
    if (part != (face == nullptr ? 0 : face->part)) return std::numeric_limits<float>::infinity();
    if (face == nullptr) return 0.0F;
    const auto* normal = seen_.geometry.normals.ptr<std::uint16_t>(at.y, at.x);
    // Vertices' normals may point inwards, all of a mesh's alike.
    const float turned = 1.0F - std::abs(fromHalf(normal[0]) * face->normal.x() +
                                         fromHalf(normal[1]) * face->normal.y() +
                                         fromHalf(normal[2]) * face->normal.z());
    const float expected =
        face->inverseDepthAt(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
    return turned + kDepth * std::abs(expected * seen_.geometry.depth.at<float>(at) - 1.0F);
  }

  [[nodiscard]] Eigen::Vector3f lightAt(const cv::Point& pixel) const {
    const cv::Point at = pixel - seen_.place.tl();
    const auto* bits = seen_.light.ptr<std::uint16_t>(at.y, at.x);
    return {fromHalf(bits[0]), fromHalf(bits[1]), fromHalf(bits[2])};
  }

  const SeenPixels& seen_;
  const SampleRaster& raster_;
};

}  // namespace

void EdgeSmoother::smooth(const EdgeScene& scene, const SeenPixels& seen,
                          const std::vector<cv::Rect>& regions, const cv::Mat& wanted,
                          cv::Mat& picture) const {
  const EdgePixels edges(seen.geometry, seen.place, regions, wanted,
                         scene.view.camera.intrinsics());
  if (edges.pixels().empty()) return;
  SampleRaster raster(scene.view, edges, seen.geometry.parts, seen.place);
  const Pose X_CW = scene.view.X_WC.inverse();
  for (const bool stand_still : {true, false}) {
    for (const Part* part : parts_.solidParts(X_CW, scene.X_WL, scene.drawn, stand_still)) {
      raster.draw(*part, static_cast<int>(parts_.numberOf(*part)), scene.X_WL[part->link]);
    }
  }
  const Resolver resolver(seen, raster);
  for (std::size_t i = 0; i < edges.pixels().size(); ++i) {
    const cv::Point& pixel = edges.pixels()[i];
    const Eigen::Vector3f light = resolver.light(pixel, i);
    picture.at<cv::Vec3b>(pixel) = {sensor::srgbFromLinear(light.z()),
                                    sensor::srgbFromLinear(light.y()),
                                    sensor::srgbFromLinear(light.x())};
  }
}

}  // namespace synthetic_dataset::render

#include "render/edge_smoother.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "render/edge_pixels.h"
#include "render/half.h"
#include "render/sample_raster.h"
#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// Finds pixels whose centres see the surface that a sample sees.
class Resolver {
 public:
  explicit Resolver(const SeenPixels& seen) : seen_(seen) {}

  /// The light of what a sample sees.
  [[nodiscard]] Eigen::Vector3f lightOf(const SeenFace* face, const cv::Point& pixel,
                                        const std::array<float, 2>& place) const {
    constexpr float kAlike = 0.01F;  // its own centre is the nearest there is
    if (unlikeness(face, pixel) < kAlike) return light(pixel);
    cv::Point best = pixel;
    float least = std::numeric_limits<float>::infinity();
    for (int dv = -1; dv <= 1; ++dv) {
      for (int du = -1; du <= 1; ++du) {
        const cv::Point other(pixel.x + du, pixel.y + dv);
        if (!seen_.place.contains(other)) continue;
        const float x = static_cast<float>(du) - place[0];
        const float y = static_cast<float>(dv) - place[1];
        const float unlike = unlikeness(face, other) + kAway * (x * x + y * y);
        if (unlike >= least) continue;
        least = unlike;
        best = other;
      }
    }
    return light(best);
  }

 private:
  static constexpr float kAway = 0.02F;   ///< what a pixel away counts, against a turn of a radian
  static constexpr float kDepth = 10.0F;  ///< what depth counts: a share of it

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

  [[nodiscard]] Eigen::Vector3f light(const cv::Point& pixel) const {
    const cv::Point at = pixel - seen_.place.tl();
    const auto* bits = seen_.light.ptr<std::uint16_t>(at.y, at.x);
    return {fromHalf(bits[0]), fromHalf(bits[1]), fromHalf(bits[2])};
  }

  const SeenPixels& seen_;
};

}  // namespace

void EdgeSmoother::smooth(const EdgeScene& scene, const SeenPixels& seen,
                          const std::vector<cv::Rect>& regions, cv::Mat& picture) const {
  const EdgePixels edges(seen.geometry, seen.place, regions, scene.view.camera.intrinsics());
  if (edges.pixels().empty()) return;
  SampleRaster raster(scene.view, edges, seen.geometry.parts, seen.place);
  const Pose X_CW = scene.view.X_WC.inverse();
  for (const bool stand_still : {true, false}) {
    for (const Part* part : parts_.solidParts(X_CW, scene.X_WL, scene.drawn, stand_still)) {
      raster.draw(*part, static_cast<int>(parts_.numberOf(*part)), scene.X_WL[part->link]);
    }
  }
  const Resolver resolver(seen);
  for (std::size_t i = 0; i < edges.pixels().size(); ++i) {
    const cv::Point& pixel = edges.pixels()[i];
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t sample = 0; sample < kSampleCount; ++sample) {
      sum += resolver.lightOf(raster.at(i, sample), pixel, kSamplePlaces[sample]);
    }
    sum /= static_cast<float>(kSampleCount);
    picture.at<cv::Vec3b>(pixel) = {sensor::srgbFromLinear(sum.z()),
                                    sensor::srgbFromLinear(sum.y()),
                                    sensor::srgbFromLinear(sum.x())};
  }
}

}  // namespace synthetic_dataset::render

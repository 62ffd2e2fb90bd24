#include "render/lens/lens_edges.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/edges/likeness.h"
#include "render/lens/ray_samples.h"
#include "render/pixels/half.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// Finds the light of what samples see, at pixels whose centres see the same surface.
class LensResolver {
 public:
  LensResolver(const PictureSamples& seen, const cv::Mat& rays) : seen_(seen), rays_(rays) {}

  [[nodiscard]] Eigen::Vector3f light(const cv::Point& pixel, std::size_t sample,
                                      const SeenPlane* plane) const {
    const cv::Point here = pixel - seen_.place.tl();
    if (unlikeness(here, plane) < likeness::kAlike) return lightAt(here);
    float least = likeness::kUnlike;
    cv::Point best = here;
    for (int dv = -1; dv <= 1; ++dv) {
      for (int du = -1; du <= 1; ++du) {
        const cv::Point there = here + cv::Point(du, dv);
        if (!cv::Rect(cv::Point(), seen_.place.size()).contains(there)) continue;
        const float x = static_cast<float>(du) - kSampleColumns[sample];
        const float y = static_cast<float>(dv) - kSampleRows[sample];
        const float sum = unlikeness(there, plane) + likeness::kAway * (x * x + y * y);
        if (!(sum < least)) continue;
        least = sum;
        best = there;
      }
    }
    return lightAt(best);
  }

 private:
  /// How little a pixel looks like a plane.
  [[nodiscard]] float unlikeness(const cv::Point& at, const SeenPlane* plane) const {
    const int item = seen_.geometry.items.at<int>(at);
    if (plane == nullptr) return item == 0 ? 0.0F : likeness::kUnlike;
    if (item != plane->item) return likeness::kUnlike;
    const auto* bits = seen_.geometry.normals.ptr<std::uint16_t>(at.y, at.x);
    const Eigen::Vector3f normal(fromHalf(bits[0]), fromHalf(bits[1]), fromHalf(bits[2]));
    // Vertices' normals may point inwards, all of a mesh's alike.
    const float turned = 1.0F - std::abs(normal.dot(plane->normal));
    const Eigen::Vector3f ray(rays_.at<cv::Vec3f>(at + seen_.place.tl()).val);
    const float off = std::abs(plane->inverse.dot(ray) * seen_.geometry.depth.at<float>(at) - 1.0F);
    return turned + likeness::kDepth * off;
  }

  [[nodiscard]] Eigen::Vector3f lightAt(const cv::Point& at) const {
    const auto* bits = seen_.light.ptr<std::uint16_t>(at.y, at.x);
    return {fromHalf(bits[0]), fromHalf(bits[1]), fromHalf(bits[2])};
  }

  const PictureSamples& seen_;
  const cv::Mat& rays_;
};

}  // namespace

void smoothEdges(const DrawList& draw_list, const EdgeScene& scene, const LensSight& sight,
                 const PictureSamples& seen, const EdgePixels& edges, cv::Mat& picture) {
  if (edges.pixels().empty()) return;
  const RaySamples samples(draw_list, scene, sight, edges.pixels());
  const LensResolver resolver(seen, sight.lens->rays);
  for (std::size_t i = 0; i < edges.pixels().size(); ++i) {
    const cv::Point& pixel = edges.pixels()[i];
    if (sight.lens->face.at<std::int16_t>(pixel) < 0) continue;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t sample = 0; sample < kSampleCount; ++sample) {
      sum += resolver.light(pixel, sample, samples.at(i, sample));
    }
    const Eigen::Vector3f light = sum / static_cast<float>(kSampleCount);
    picture.at<cv::Vec3b>(pixel) = {render::srgbFromLinear(light.z()),
                                    render::srgbFromLinear(light.y()),
                                    render::srgbFromLinear(light.x())};
  }
}

}  // namespace synthetic_dataset::render

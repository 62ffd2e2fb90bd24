#include "render/lens/lens_edges.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/types.hpp>
#include <opencv2/core/utility.hpp>

#include "render/edges/edge_smoother.h"
#include "render/edges/sample_raster.h"
#include "render/lens/lens_map.h"
#include "render/lens/lens_sight.h"
#include "render/lens/ray_grid.h"
#include "render/lens/ray_raster.h"
#include "render/lens/row_raster.h"
#include "render/parts/draw_list.h"
#include "render/pixels/half.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// The plane of a visible triangle, in the lens's frame.
struct SeenPlane {
  int item = 0;
  Eigen::Vector3f normal{0.0F, 0.0F, 0.0F};   ///< of unit length
  Eigen::Vector3f inverse{0.0F, 0.0F, 0.0F};  ///< inverse * p = 1 for its points p
};

/// What the samples of some pixels see through a lens, each along its own ray.
class RaySamples {
 public:
  /// @param pixels  pixels with which the lens sees something
  RaySamples(const DrawList& draw_list, const EdgeScene& scene, const LensSight& sight,
             const std::vector<cv::Point>& pixels);

  /// The plane that a sample of pixels[pixel] sees, or null.
  [[nodiscard]] const SeenPlane* at(std::size_t pixel, std::size_t sample) const {
    const int plane = samples_[pixel * kSampleCount + sample];
    return plane < 0 ? nullptr : &planes_[static_cast<std::size_t>(plane)];
  }

 private:
  template <class Grids>
  void take(const Grids& grids, const RaySights& sights, const LensSight& sight);

  std::vector<int> samples_;  ///< the index of each sample's plane; -1 for none
  std::vector<SeenPlane> planes_;
};

/// The samples' places on each of the faces; a sample's index is its pixel's index times
/// kSampleCount plus its number in the pixel.
std::vector<std::vector<PlacedRay>> samplesOf(const LensMap& lens,
                                              const std::vector<cv::Point>& pixels) {
  std::vector<std::vector<PlacedRay>> rays(lens.faces.size());
  std::vector<FacePlane> planes;
  for (const LensFace& face : lens.faces) planes.emplace_back(face);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto face = lens.face.at<std::int16_t>(pixels[i]);
    if (face < 0) continue;
    const FacePlane& plane = planes[static_cast<std::size_t>(face)];
    const Eigen::Vector2f place = plane.placeOf(lens.rays.at<cv::Vec3f>(pixels[i]));
    const auto stepTo = [&](int du, int dv) -> Eigen::Vector2f {
      const int side = neighbourSide(lens, lens.faces[static_cast<std::size_t>(face)].X_CF,
                                     pixels[i].x, pixels[i].y, du, dv);
      const cv::Point neighbour(pixels[i].x + side * du, pixels[i].y + side * dv);
      return static_cast<float>(side) * (plane.placeOf(lens.rays.at<cv::Vec3f>(neighbour)) - place);
    };
    const Eigen::Vector2f across = stepTo(1, 0);
    const Eigen::Vector2f along = stepTo(0, 1);
    for (std::size_t sample = 0; sample < kSampleCount; ++sample) {
      const Eigen::Vector2f there =
          place + kSampleColumns[sample] * across + kSampleRows[sample] * along;
      rays[static_cast<std::size_t>(face)].push_back(
          {there.x(), there.y(), static_cast<int>(i * kSampleCount + sample)});
    }
  }
  return rays;
}

const std::vector<int>& raysOf(const RayGrid& grid) { return grid.rays; }
const std::vector<int>& raysOf(const RowRayGrid& rows) { return rows.grid.rays; }

SeenPlane planeOf(const SeenTriangle& triangle, const LensSight& sight) {
  const auto corners = sight.cornersOf(triangle);
  const Eigen::Vector3d normal =
      (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  return {triangle.item, normal.cast<float>(), (normal / normal.dot(corners[0])).cast<float>()};
}

template <class Grids>
void RaySamples::take(const Grids& grids, const RaySights& sights, const LensSight& sight) {
  planes_.reserve(sights.seen.size());
  for (const SeenTriangle& triangle : sights.seen) planes_.push_back(planeOf(triangle, sight));
  for (std::size_t face = 0; face < grids.size(); ++face) {
    const std::vector<int>& rays = raysOf(grids[face]);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      samples_[static_cast<std::size_t>(rays[i])] = sights.triangles[face][i];
    }
  }
}

RaySamples::RaySamples(const DrawList& draw_list, const EdgeScene& scene, const LensSight& sight,
                       const std::vector<cv::Point>& pixels)
    : samples_(pixels.size() * kSampleCount, -1) {
  const LensMap& lens = *sight.lens;
  const std::vector<std::vector<PlacedRay>> rays = samplesOf(lens, pixels);
  const RayRaster::IsHole is_hole = holesIn(draw_list, sight.surfaces);
  const Pose X_CW = scene.view.X_WC.inverse();
  const auto look = [&](auto grids, const auto& make_grid, const auto& draw) {
    for (std::size_t face = 0; face < rays.size(); ++face) {
      grids.push_back(make_grid(lens.grids[face], rays[face]));
    }
    RaySights sights(grids);
    for (const bool stand_still : {true, false}) {
      for (const DrawItem* item :
           draw_list.solidItems(X_CW, scene.X_WL, scene.drawn, stand_still)) {
        draw(grids, *item, static_cast<int>(draw_list.numberOf(*item)), sights);
      }
    }
    take(grids, sights, sight);
  };
  if (sight.rows == nullptr) {
    look(
        std::vector<RayGrid>(),
        [](const RayGrid& face, const std::vector<PlacedRay>& here) {
          return makeRayGrid(face.intrinsics, face.cells, here);
        },
        [&](const auto& grids, const DrawItem& item, int number, RaySights& sights) {
          RayRaster(scene.view, lens, grids, is_hole)
              .draw(item, number, scene.X_WL[item.link], sights);
        });
    return;
  }
  const auto row_of = [&](int ray) {
    return pixels[static_cast<std::size_t>(ray) / kSampleCount].y;
  };
  look(
      std::vector<RowRayGrid>(),
      [&](const RayGrid& face, const std::vector<PlacedRay>& here) {
        return makeRowRayGrid(face.intrinsics, face.cells, here, sight.rows->rowCount(), row_of);
      },
      [&](const auto& grids, const DrawItem& item, int number, RaySights& sights) {
        RowRaster(*sight.rows, lens, grids, is_hole).draw(item, number, sights);
      });
}

/// Finds the light of what samples see, by taking it from pixels whose centres see the same
/// surface.
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
  /// How much what a pixel shows differs from a plane.
  [[nodiscard]] float unlikeness(const cv::Point& at, const SeenPlane* plane) const {
    const int item = seen_.geometry.items.at<int>(at);
    if (plane == nullptr) return item == 0 ? 0.0F : likeness::kUnlike;
    if (item != plane->item) return likeness::kUnlike;
    const auto* bits = seen_.geometry.normals.ptr<std::uint16_t>(at.y, at.x);
    const Eigen::Vector3f normal(fromHalf(bits[0]), fromHalf(bits[1]), fromHalf(bits[2]));
    // The vertices' normals may point inwards, consistently for a whole mesh.
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
  const auto smoothOne = [&](std::size_t i) {
    const cv::Point& pixel = edges.pixels()[i];
    if (sight.lens->face.at<std::int16_t>(pixel) < 0) return;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t sample = 0; sample < kSampleCount; ++sample) {
      sum += resolver.light(pixel, sample, samples.at(i, sample));
    }
    const Eigen::Vector3f light = sum / static_cast<float>(kSampleCount);
    picture.at<cv::Vec3b>(pixel) = {render::srgbFromLinear(light.z()),
                                    render::srgbFromLinear(light.y()),
                                    render::srgbFromLinear(light.x())};
  };
  cv::parallel_for_(cv::Range(0, static_cast<int>(edges.pixels().size())),
                    [&](const cv::Range& some) {
                      for (int i = some.start; i < some.end; ++i) {
                        smoothOne(static_cast<std::size_t>(i));
                      }
                    });
}

}  // namespace synthetic_dataset::render

#include "render/lens/ray_samples.h"

#include <array>

#include <Eigen/Geometry>

#include "render/lens/lens_map.h"
#include "render/lens/ray_grid.h"
#include "render/lens/ray_raster.h"
#include "render/lens/row_raster.h"

namespace synthetic_dataset::render {
namespace {

/// The samples' places on each of the faces; a sample's index is its pixel's times kSampleCount and
/// its own.
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

}  // namespace

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

}  // namespace synthetic_dataset::render

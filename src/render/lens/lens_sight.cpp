#include "render/lens/lens_sight.h"

#include <Eigen/Geometry>

namespace synthetic_dataset::render {

RayRaster::IsHole holesIn(const DrawList& draw_list,
                          const std::shared_ptr<const std::vector<ItemSurface>>& surfaces) {
  return [&draw_list, surfaces](const DrawItem& item, const RayRaster::Place& place) {
    const ItemSurface& surface = (*surfaces)[draw_list.numberOf(item)];
    if (!surface.colours) return false;
    const FacedTriangle triangle(place.corners_F, place.vertices, surface);
    const auto fx = static_cast<float>(place.intrinsics.fx);
    const auto fy = static_cast<float>(place.intrinsics.fy);
    const Eigen::Vector3f ray((place.column - static_cast<float>(place.intrinsics.cx)) / fx,
                              (place.row - static_cast<float>(place.intrinsics.cy)) / fy, 1.0F);
    const auto on = triangle.onTexture(ray, {0.5F / fx, 0.0F, 0.0F}, {0.0F, 0.5F / fy, 0.0F});
    return surface.colours->sample(on.place, on.across, on.along).w() < surface.alpha_threshold;
  };
}

Pose LensSight::poseOf(const SeenTriangle& triangle) const {
  return triangle.row < 0 ? X_CV[static_cast<std::size_t>(triangle.item)]
                          : rows->X_CV(triangle.item, triangle.row);
}

std::array<Eigen::Vector3d, 3> LensSight::cornersOf(const SeenTriangle& triangle) const {
  const world::Mesh& mesh = *(*surfaces)[static_cast<std::size_t>(triangle.item)].shape;
  const Pose pose = poseOf(triangle);
  const auto corner = [&](std::uint32_t i) -> Eigen::Vector3d {
    return pose * mesh.positions[mesh.indices[triangle.first + i]].cast<double>();
  };
  return {corner(0), corner(1), corner(2)};
}

double distanceTo(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  return normal.dot(corners[0]) / normal.dot(ray);
}

FacedTriangle LensSight::triangleAt(int index) const {
  const SeenTriangle& triangle = seen[static_cast<std::size_t>(index)];
  const auto item = static_cast<std::size_t>(triangle.item);
  const ItemSurface& surface = (*surfaces)[item];
  const std::array<Eigen::Vector3d, 3> corners = cornersOf(triangle);
  const auto& indices = surface.shape->indices;
  return {{corners[0].cast<float>(), corners[1].cast<float>(), corners[2].cast<float>()},
          {indices[triangle.first], indices[triangle.first + 1], indices[triangle.first + 2]},
          surface};
}

}  // namespace synthetic_dataset::render

#include "render/shadows/held_casters.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "render/parts/bounds.h"

namespace synthetic_dataset::render {
namespace {

/// The place of a point of a caster.
struct Caster {
  Eigen::Vector3d point_W;
  Eigen::Vector2d texel;  ///< of the map
  double texel_size;      ///< at the point [m]; 0 or less behind a light

  Caster(const Eigen::Vector3d& p_W, const ShadowProjection& shadow) : point_W(p_W) {
    const Eigen::Vector4d p = shadow.shadow_from_world * p_W.homogeneous();
    texel = 0.5 * shadow.size / p.w() * p.head<2>();
    texel_size = shadow.texel * p.w();
  }
};

/// By how many texels a shadow moves with its caster: on the map, or in distance in the world.
double texelsBetween(const Caster& one, const Caster& other) {
  if (one.point_W == other.point_W) return 0.0;
  const double size = std::min(one.texel_size, other.texel_size);
  if (!(size > 0.0)) return std::numeric_limits<double>::infinity();
  return std::max((one.texel - other.texel).norm(), (one.point_W - other.point_W).norm() / size);
}

/// Whether all of some points of a link move by less than this many texels between two poses.
bool areWithin(double texels, const ShadowProjection& shadow,
               const std::vector<Eigen::Vector3d>& points_L, const Pose& one, const Pose& other) {
  return std::all_of(points_L.begin(), points_L.end(), [&](const Eigen::Vector3d& point) {
    return texelsBetween({one * point, shadow}, {other * point, shadow}) < texels;
  });
}

}  // namespace

std::vector<CasterPoses> heldForShadows(const std::vector<DrawItem>& items,
                                        const std::vector<const std::vector<Pose>*>& X_WL,
                                        const std::vector<ShadowProjection>& shadows,
                                        double texels) {
  std::vector<CasterPoses> held;
  for (const std::vector<Pose>* poses : X_WL) held.emplace_back(shadows.size(), *poses);
  std::vector<std::vector<Eigen::Vector3d>> corners(X_WL.empty() ? 0 : X_WL.front()->size());
  for (const DrawItem& item : items) {
    if (!item.casts_shadow || item.stands_still || item.bounds_V.isEmpty()) continue;
    for (const Eigen::Vector3d& corner : cornersOf(item.bounds_V)) {
      corners[item.link].push_back(item.X_LV * corner);
    }
  }
  for (std::size_t link = 0; link < corners.size(); ++link) {
    if (corners[link].empty()) continue;
    const auto at = [&](std::size_t time) -> const Pose& { return (*X_WL[time])[link]; };
    for (std::size_t shadow = 0; shadow < shadows.size(); ++shadow) {
      const auto areNear = [&](std::size_t one, std::size_t other) {
        return areWithin(0.5 * texels, shadows[shadow], corners[link], at(one), at(other));
      };
      for (std::size_t first = 0; first < held.size();) {
        std::size_t middle = first;
        while (middle + 1 < held.size() && areNear(first, middle + 1)) ++middle;
        std::size_t end = middle + 1;
        while (end < held.size() && areNear(middle, end)) ++end;
        for (std::size_t time = first; time < end; ++time) {
          held[time][shadow][link] = at(middle);
        }
        first = end;
      }
    }
  }
  return held;
}

}  // namespace synthetic_dataset::render

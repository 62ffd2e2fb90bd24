#include "lidar/scanned_world.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lidar/surface_look.h"

namespace synthetic_dataset::lidar {
namespace {

using render::GlassInLabels;

/// The surfaces of a link that rays can hit.
/// @param X_BL  of the link in its body
std::vector<RaySurface> surfacesOf(const world::LinkInstance& instance, std::size_t link,
                                   const Pose& X_BL, GlassInLabels glass) {
  const bool shows_glass = glass == GlassInLabels::kSolid ||
                           (glass == GlassInLabels::kOfObjects && instance.object >= 0);
  std::vector<RaySurface> surfaces;
  for (const world::Visual& visual : instance.link->visuals) {
    for (const world::Surface& surface : visual.surfaces) {
      if (surface.mesh->indices.empty()) continue;
      if (!shows_glass && isTransparent(*surface.mesh, surface.material)) continue;
      surfaces.push_back(
          {surface.mesh, &surface.material, link, X_BL * visual.X_LV, hasHoles(surface.material)});
    }
  }
  return surfaces;
}

/// The box around all corners, in the body's frame.
Eigen::AlignedBox3d boundsOf(const std::vector<RaySurface>& surfaces) {
  Eigen::AlignedBox3d bounds;
  for (const RaySurface& surface : surfaces) {
    for (const Eigen::Vector3f& p_V : surface.mesh->positions) {
      bounds.extend(Eigen::Vector3d(surface.X_BV * p_V.cast<double>()));
    }
  }
  return bounds;
}

/// The median of the surfaces' centres: one that is far from all others does not shift it.
Eigen::Vector3d middleOf(const std::vector<RaySurface>& surfaces) {
  std::vector<Eigen::Vector3d> centres;
  for (const RaySurface& surface : surfaces) centres.emplace_back(boundsOf({surface}).center());
  const auto half = centres.begin() + static_cast<std::ptrdiff_t>(centres.size() / 2);
  Eigen::Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::nth_element(centres.begin(), half, centres.end(),
                     [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    middle[axis] = (*half)[axis];
  }
  return middle;
}

}  // namespace

ScannedWorld::ScannedWorld(const world::World& world, GlassInLabels glass)
    : simulator_(world.description().simulator) {
  const std::vector<world::LinkInstance>& links = world.links();
  std::vector<RaySurface> standing;
  for (std::size_t link = 0; link < links.size(); ++link) {
    const bool stands = links[link].role == world::Role::kStatic;
    const Pose X_BL = stands ? world.linkPoses()[link] : Pose::Identity();
    std::vector<RaySurface> surfaces = surfacesOf(links[link], link, X_BL, glass);
    if (surfaces.empty()) continue;
    if (stands) {
      std::move(surfaces.begin(), surfaces.end(), std::back_inserter(standing));
      continue;
    }
    const Eigen::AlignedBox3d bounds = boundsOf(surfaces);
    moving_.push_back(
        {link, bodies_.add(std::move(surfaces)), bounds.center(), 0.5 * bounds.diagonal().norm()});
  }
  if (standing.empty()) return;
  // Single precision is fine near the origin, and worlds may be far away from theirs.
  origin_W_ = middleOf(standing).array().round();
  Pose X_BW = Pose::Identity();
  X_BW.translation() = -origin_W_;
  for (RaySurface& surface : standing) surface.X_BV = X_BW * surface.X_BV;
  standing_ = bodies_.add(std::move(standing));
}

Paint ScannedWorld::paint(const std::map<const world::Material*, world::Material>& varied) const {
  Paint paint;
  for (const RaySurface& surface : bodies_.surfaces()) {
    const auto found = varied.find(surface.material);
    paint.push_back(found != varied.end() ? &found->second : surface.material);
  }
  return paint;
}

}  // namespace synthetic_dataset::lidar

#include "render/draw_list.h"

#include <algorithm>
#include <utility>

namespace synthetic_dataset::render {
namespace {

/// A flat thing of this size is ground: as a caster it would only stretch the shadow map.
constexpr double kLargestFlatCaster = 20.0;  // [m]

Bounds boundsOf(const world::Mesh& mesh) {
  Bounds bounds;
  for (const Eigen::Vector3f& position : mesh.positions) bounds.extend(position.cast<double>());
  return bounds;
}

bool isLargeAndFlat(const Bounds& bounds) {
  return !bounds.isEmpty() && bounds.sizes().minCoeff() < 1e-6 &&
         bounds.sizes().maxCoeff() > kLargestFlatCaster;
}

}  // namespace

DrawList::DrawList(const GlFunctions& gl, const std::vector<world::LinkInstance>& links)
    : meshes_(gl), textures_(gl) {
  for (std::size_t link = 0; link < links.size(); ++link) {
    for (const world::Visual& visual : links[link].link->visuals) {
      for (const world::Surface& surface : visual.surfaces) {
        Part part;
        part.mesh = &meshes_.get(surface.mesh);
        part.material = &surface.material;
        part.texture = surface.material.texture ? textures_.get(surface.material.texture) : 0;
        part.link = link;
        part.identifier = static_cast<std::uint32_t>(links[link].object + 1);
        part.X_LV = visual.X_LV;
        part.bounds_V = boundsOf(*surface.mesh);
        part.casts_shadow =
            visual.casts_shadow && !part.transparent() && !isLargeAndFlat(part.bounds_V);
        parts_.push_back(part);
      }
    }
  }
}

Bounds DrawList::casterBounds(const std::vector<Pose>& X_WL, const LinkSelection& casting) const {
  Bounds bounds;
  for (const Part& part : parts_) {
    if (!part.casts_shadow || !casting[part.link] || part.bounds_V.isEmpty()) continue;
    const Pose X_WV = X_WL[part.link] * part.X_LV;
    for (int i = 0; i < 8; ++i) {
      bounds.extend(X_WV * part.bounds_V.corner(static_cast<Bounds::CornerType>(i)));
    }
  }
  return bounds;
}

std::vector<const Part*> DrawList::transparentParts(const Pose& X_CW, const std::vector<Pose>& X_WL,
                                                    const LinkSelection& drawn) const {
  std::vector<std::pair<double, const Part*>> sorted;
  for (const Part& part : parts_) {
    if (!drawn[part.link] || !part.transparent() || part.bounds_V.isEmpty()) continue;
    const Eigen::Vector3d centre = X_CW * X_WL[part.link] * part.X_LV * part.bounds_V.center();
    sorted.emplace_back(-centre.z(), &part);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Part*> result;
  for (const auto& entry : sorted) result.push_back(entry.second);
  return result;
}

}  // namespace synthetic_dataset::render

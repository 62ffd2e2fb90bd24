#include "render/parts/draw_list.h"

#include <algorithm>
#include <utility>

#include "render/parts/part_light.h"
#include "world/mesh/closed_surface.h"

namespace synthetic_dataset::render {
namespace {

/// A flat thing of this size is ground: as a caster it would only stretch the shadow map.
constexpr double kLargestFlatCaster = 20.0;  // [m]

Bounds boundsOf(const world::Mesh& mesh) {
  Bounds bounds;
  for (const Eigen::Vector3f& position : mesh.positions) bounds.extend(position.cast<double>());
  return bounds;
}

PixelMeaning meaningOfColours(world::Simulator simulator) {
  return simulator == world::Simulator::kClassic ? PixelMeaning::kData : PixelMeaning::kColour;
}

bool isLargeAndFlat(const Bounds& bounds) {
  return !bounds.isEmpty() && bounds.sizes().minCoeff() < 1e-6 &&
         bounds.sizes().maxCoeff() > kLargestFlatCaster;
}

bool seenThrough(const world::Mesh& mesh) {
  return hasColours(mesh) &&
         std::any_of(mesh.colours.begin(), mesh.colours.end(),
                     [](const Eigen::Vector4f& colour) { return colour.w() < 1.0F; });
}

/// What the diffuse picture's alpha means; nothing where it is 1 everywhere.
SurfaceFeatures alphaFeatures(const world::Material& material, bool opaque) {
  if (opaque) return 0;
  if (material.texture_is_glass) return feature::kGlass;
  return material.alpha_threshold > 0.0F ? feature::kHoles : 0;
}

}  // namespace

void extend(Bounds& bounds, const Part& part, const Pose& X_WL) {
  if (part.bounds_V.isEmpty()) return;
  const Pose X_WV = X_WL * part.X_LV;
  for (const Eigen::Vector3d& corner : cornersOf(part.bounds_V)) bounds.extend(X_WV * corner);
}

DrawList::DrawList(const GlFunctions& gl, const std::vector<world::LinkInstance>& links,
                   world::Simulator simulator, GlassInLabels glass)
    : simulator_(simulator),
      glass_(glass),
      meshes_(gl, meaningOfColours(simulator)),
      textures_(gl) {
  for (std::size_t link = 0; link < links.size(); ++link) {
    for (const world::Visual& visual : links[link].link->visuals) {
      for (const world::Surface& surface : visual.surfaces) {
        const world::Material* material = &surface.material;
        for (; material != nullptr; material = material->overlay.get()) {
          Part part = makePart(surface.mesh, *material);
          part.link = link;
          part.identifier = static_cast<std::uint32_t>(links[link].object + 1);
          part.stands_still = links[link].role == world::Role::kStatic;
          place(visual, surface, part);
          part.seen_through_in_labels = isSeenThroughInLabels(part);
          features_ |= part.features;
          parts_.push_back(std::move(part));
        }
      }
    }
  }
}

bool DrawList::isSeenThroughInLabels(const Part& part) const {
  if (!part.transparent || glass_ == GlassInLabels::kSolid) return false;
  return glass_ == GlassInLabels::kClear || part.identifier == 0;
}

void DrawList::place(const world::Visual& visual, const world::Surface& surface, Part& part) {
  part.X_LV = visual.X_LV;
  part.casts_shadow = visual.casts_shadow && !part.transparent && !isLargeAndFlat(part.bounds_V);
  // What stands still casts its shadow but once.
  part.casts_by_front =
      part.casts_shadow && !part.stands_still && !part.has_holes && isSurfaceOfBodies(surface.mesh);
  if (!part.stands_still || part.transparent) part.hull_V = &hullOf(*surface.mesh);
}

const BoundingHull& DrawList::hullOf(const world::Mesh& mesh) {
  const auto [found, is_new] = hulls_.try_emplace(&mesh);
  if (is_new) found->second = boundingHullOf(mesh);
  return found->second;
}

bool DrawList::isSurfaceOfBodies(const std::shared_ptr<const world::Mesh>& mesh) {
  const auto [found, is_new] = surfaces_of_bodies_.try_emplace(mesh.get(), false);
  if (is_new) found->second = world::isSurfaceOfBodies(*mesh);
  return found->second;
}

Part DrawList::makePart(const std::shared_ptr<const world::Mesh>& mesh,
                        const world::Material& material) {
  Part part;
  part.mesh = &meshes_.get(mesh);
  part.shape = mesh.get();
  part.given = part.material = &material;
  part.bounds_V = boundsOf(*mesh);
  dress(part);
  part.double_sided = material.double_sided;
  part.has_holes = (part.features & feature::kHoles) != 0;
  part.transparent =
      material.diffuse.w() < 1.0F || (part.features & feature::kGlass) != 0 || seenThrough(*mesh);
  return part;
}

/// Finds what a part's material asks for.
void DrawList::dress(Part& part) {
  const world::Material& material = *part.material;
  part.features = 0;
  part.textures = {};
  const auto use = [&](const std::shared_ptr<const world::Texture>& texture, PixelMeaning meaning,
                       SurfaceFeatures feature, GLuint& name) {
    if (!texture) return;
    name = textures_.get(texture, meaning).texture.name();
    part.features |= feature;
  };
  const PixelMeaning colours = meaningOfColours(simulator_);
  PartTextures& names = part.textures;
  use(material.texture, colours, feature::kTextured, names.diffuse);
  if (material.texture) {
    const auto& uploaded = textures_.get(material.texture, colours);
    part.features |= alphaFeatures(material, uploaded.opaque);
  }
  if (hasColours(*part.shape)) part.features |= feature::kTinted;
  if (material.lit) {
    use(material.normal_map, PixelMeaning::kData, feature::kNormalMap, names.normal);
    if (!isClassic() || hasGlowOfItsOwn(material)) {
      use(material.emissive_map, colours, feature::kEmissiveMap, names.emissive);
    }
    if (isClassic()) return;  // whose highlights are the same all over a surface
    use(material.roughness_map, PixelMeaning::kData, feature::kRoughnessMap, names.roughness);
    use(material.metalness_map, PixelMeaning::kData, feature::kMetalnessMap, names.metalness);
  } else {
    part.features |= feature::kUnlit;
  }
}

void DrawList::setMaterials(const std::map<const world::Material*, world::Material>& materials) {
  varied_ = materials;
  features_ = 0;
  for (Part& part : parts_) {
    const auto varied = varied_.find(part.given);
    part.material = varied != varied_.end() ? &varied->second : part.given;
    dress(part);
    features_ |= part.features;
  }
  textures_.forgetUnused();
}

Bounds DrawList::casterBounds(const std::vector<Pose>& X_WL, const LinkSelection& casting) const {
  Bounds standing;
  Bounds moving;
  for (const Part& part : parts_) {
    if (!part.casts_shadow || !casting[part.link]) continue;
    extend(part.stands_still ? standing : moving, part, X_WL[part.link]);
  }
  if (moving.isEmpty()) return standing;
  // In steps, so that shadow maps fit from picture to picture.
  constexpr double kStep = 0.5;  // [m]
  standing.extend(Eigen::Vector3d((moving.min() / kStep).array().floor() * kStep));
  standing.extend(Eigen::Vector3d((moving.max() / kStep).array().ceil() * kStep));
  return standing;
}

LinkSelection DrawList::standing(const LinkSelection& links) const {
  LinkSelection selected(links.size(), false);
  for (const Part& part : parts_) {
    if (part.stands_still) selected[part.link] = links[part.link];
  }
  return selected;
}

bool DrawList::hasGlassInLabels(const LinkSelection& drawn) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) {
    return drawn[part.link] && part.transparent && !part.seen_through_in_labels;
  });
}

std::vector<const Part*> DrawList::solidParts(const Pose& X_CW, const std::vector<Pose>& X_WL,
                                              const LinkSelection& drawn, bool stands_still) const {
  return sorted(X_CW, X_WL, drawn, 1.0, [&](const Part& part) {
    return !part.transparent && part.stands_still == stands_still;
  });
}

std::vector<const Part*> DrawList::transparentParts(const Pose& X_CW, const std::vector<Pose>& X_WL,
                                                    const LinkSelection& drawn) const {
  return sorted(X_CW, X_WL, drawn, -1.0, [](const Part& part) { return part.transparent; });
}

std::vector<const Part*> DrawList::sorted(const Pose& X_CW, const std::vector<Pose>& X_WL,
                                          const LinkSelection& drawn, double sign,
                                          const std::function<bool(const Part&)>& wanted) const {
  std::vector<std::pair<double, const Part*>> parts;
  for (const Part& part : parts_) {
    if (!drawn[part.link] || !wanted(part) || part.bounds_V.isEmpty()) continue;
    const Eigen::Vector3d centre = X_CW * X_WL[part.link] * part.X_LV * part.bounds_V.center();
    parts.emplace_back(sign * centre.z(), &part);
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Part*> result;
  result.reserve(parts.size());
  for (const auto& entry : parts) result.push_back(entry.second);
  return result;
}

}  // namespace synthetic_dataset::render

#include "render/parts/draw_list.h"

#include <algorithm>
#include <utility>

#include "render/parts/item_surface.h"
#include "world/mesh/closed_surface.h"

namespace synthetic_dataset::render {
namespace {

/// A flat item larger than this is ground: as a caster it would only stretch the shadow map.
constexpr double kLargestFlatCaster = 20.0;  // [m]

Bounds meshBounds(const world::Mesh& mesh) {
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

/// What the diffuse texture's alpha means; no features if it is 1 everywhere.
SurfaceFeatures alphaFeatures(const world::Material& material, bool opaque) {
  if (opaque) return 0;
  if (material.texture_is_glass) return feature::kGlass | feature::kHoles;
  return material.alpha_threshold > 0.0F ? feature::kHoles : 0;
}

}  // namespace

void extend(Bounds& bounds, const DrawItem& item, const Pose& X_WL) {
  if (item.bounds_V.isEmpty()) return;
  const Pose X_WV = X_WL * item.X_LV;
  for (const Eigen::Vector3d& corner : cornersOf(item.bounds_V)) bounds.extend(X_WV * corner);
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
          DrawItem item = makeItem(surface.mesh, *material);
          item.link = link;
          item.identifier = static_cast<std::uint32_t>(links[link].object + 1);
          item.stands_still = links[link].role == world::Role::kStatic;
          place(visual, surface, item);
          seeThroughInLabels(item);
          features_ |= item.features;
          items_.push_back(std::move(item));
        }
      }
    }
  }
}

/// Makes labels leave out a transparent item if GlassInLabels says so. If only its texture makes it
/// transparent, they still show its opaque texels.
void DrawList::seeThroughInLabels(DrawItem& item) const {
  const bool is_chosen = glass_ == GlassInLabels::kClear ||
                         (glass_ == GlassInLabels::kOfObjects && item.identifier == 0);
  if (!item.transparent || !is_chosen) return;
  const bool is_by_picture = (item.features & feature::kGlass) != 0 &&
                             item.material->diffuse.w() >= 1.0F && !seenThrough(*item.shape);
  if (is_by_picture) item.alpha_threshold = kOpaque;
  item.seen_through_in_labels = !is_by_picture;
}

void DrawList::place(const world::Visual& visual, const world::Surface& surface, DrawItem& item) {
  item.X_LV = visual.X_LV;
  item.casts_shadow = visual.casts_shadow && !item.transparent && !isLargeAndFlat(item.bounds_V);
  // What never moves casts its shadow only once, so this would not pay.
  item.casts_by_front =
      item.casts_shadow && !item.stands_still && !item.has_holes && isSurfaceOfBodies(surface.mesh);
  if (!item.stands_still || item.transparent) item.hull_V = &hullOf(*surface.mesh);
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

DrawItem DrawList::makeItem(const std::shared_ptr<const world::Mesh>& mesh,
                            const world::Material& material) {
  DrawItem item;
  item.mesh = &meshes_.get(mesh);
  item.shape = mesh.get();
  item.given = item.material = &material;
  item.bounds_V = meshBounds(*mesh);
  dress(item);
  item.double_sided = material.double_sided;
  item.has_holes = (item.features & feature::kHoles) != 0;
  item.transparent =
      material.diffuse.w() < 1.0F || (item.features & feature::kGlass) != 0 || seenThrough(*mesh);
  return item;
}

/// Determines the textures and features that an item's material requires.
void DrawList::dress(DrawItem& item) {
  const world::Material& material = *item.material;
  item.features = 0;
  item.textures = {};
  const auto use = [&](const std::shared_ptr<const world::Texture>& texture, PixelMeaning meaning,
                       SurfaceFeatures feature, GLuint& name) {
    if (!texture) return;
    name = textures_.get(texture, meaning).texture.name();
    item.features |= feature;
  };
  const PixelMeaning colours = meaningOfColours(simulator_);
  ItemTextures& names = item.textures;
  use(material.texture, colours, feature::kTextured, names.diffuse);
  item.alpha_threshold = material.texture_is_glass ? kLeastOpacity : material.alpha_threshold;
  if (material.texture) {
    const auto& uploaded = textures_.get(material.texture, colours);
    item.features |= alphaFeatures(material, uploaded.opaque);
  }
  if (hasColours(*item.shape)) item.features |= feature::kTinted;
  if (material.lit) {
    use(material.normal_map, PixelMeaning::kData, feature::kNormalMap, names.normal);
    if (!isClassic() || hasGlowOfItsOwn(material)) {
      use(material.emissive_map, colours, feature::kEmissiveMap, names.emissive);
    }
    if (isClassic()) return;  // whose highlights do not vary over a surface
    use(material.roughness_map, PixelMeaning::kData, feature::kRoughnessMap, names.roughness);
    use(material.metalness_map, PixelMeaning::kData, feature::kMetalnessMap, names.metalness);
  } else {
    item.features |= feature::kUnlit;
  }
}

void DrawList::setMaterials(const std::map<const world::Material*, world::Material>& materials) {
  varied_ = materials;
  features_ = 0;
  for (DrawItem& item : items_) {
    const auto varied = varied_.find(item.given);
    item.material = varied != varied_.end() ? &varied->second : item.given;
    dress(item);
    seeThroughInLabels(item);
    features_ |= item.features;
  }
  textures_.forgetUnused();
}

Bounds DrawList::casterBounds(const std::vector<Pose>& X_WL, const LinkSelection& casting) const {
  Bounds standing;
  Bounds moving;
  for (const DrawItem& item : items_) {
    if (!item.casts_shadow || !casting[item.link]) continue;
    extend(item.stands_still ? standing : moving, item, X_WL[item.link]);
  }
  if (moving.isEmpty()) return standing;
  // In steps, so that the shadow maps of consecutive pictures match.
  constexpr double kStep = 0.5;  // [m]
  standing.extend(Eigen::Vector3d((moving.min() / kStep).array().floor() * kStep));
  standing.extend(Eigen::Vector3d((moving.max() / kStep).array().ceil() * kStep));
  return standing;
}

LinkSelection DrawList::standing(const LinkSelection& links) const {
  LinkSelection selected(links.size(), false);
  for (const DrawItem& item : items_) {
    if (item.stands_still) selected[item.link] = links[item.link];
  }
  return selected;
}

bool DrawList::hasGlassInLabels(const LinkSelection& drawn) const {
  return std::any_of(items_.begin(), items_.end(), [&](const DrawItem& item) {
    return drawn[item.link] && item.transparent && !item.seen_through_in_labels;
  });
}

std::vector<const DrawItem*> DrawList::solidItems(const Pose& X_CW, const std::vector<Pose>& X_WL,
                                                  const LinkSelection& drawn,
                                                  bool stands_still) const {
  return sorted(X_CW, X_WL, drawn, 1.0, [&](const DrawItem& item) {
    return !item.transparent && item.stands_still == stands_still;
  });
}

std::vector<const DrawItem*> DrawList::transparentItems(const Pose& X_CW,
                                                        const std::vector<Pose>& X_WL,
                                                        const LinkSelection& drawn) const {
  return sorted(X_CW, X_WL, drawn, -1.0, [](const DrawItem& item) { return item.transparent; });
}

std::vector<const DrawItem*> DrawList::sorted(
    const Pose& X_CW, const std::vector<Pose>& X_WL, const LinkSelection& drawn, double sign,
    const std::function<bool(const DrawItem&)>& wanted) const {
  std::vector<std::pair<double, const DrawItem*>> items;
  for (const DrawItem& item : items_) {
    if (!drawn[item.link] || !wanted(item) || item.bounds_V.isEmpty()) continue;
    const Eigen::Vector3d centre = X_CW * X_WL[item.link] * item.X_LV * item.bounds_V.center();
    items.emplace_back(sign * centre.z(), &item);
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const DrawItem*> result;
  result.reserve(items.size());
  for (const auto& entry : items) result.push_back(entry.second);
  return result;
}

}  // namespace synthetic_dataset::render

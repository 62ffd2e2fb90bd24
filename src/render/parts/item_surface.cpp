#include "render/parts/item_surface.h"

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

ItemSurface surfaceOf(const DrawItem& item, bool is_classic, PyramidLibrary& pyramids) {
  const world::Material& material = *item.material;
  const PixelMeaning colours = is_classic ? PixelMeaning::kData : PixelMeaning::kColour;
  ItemSurface surface;
  surface.shape = item.shape;
  surface.diffuse = linearFromSrgb(material.diffuse);
  if (is_classic) surface.diffuse.head<3>().setOnes();
  surface.scale = material.texture_scale;
  surface.offset = material.texture_offset;
  surface.roughness = material.roughness;
  surface.metalness = material.metalness;
  surface.alpha_threshold = item.alpha_threshold;
  const auto has = [&](SurfaceFeatures feature) { return (item.features & feature) != 0; };
  if (has(feature::kTinted)) surface.tints = &item.shape->colours;
  surface.tints_are_encoded = !is_classic;
  const auto get = [&](SurfaceFeatures feature,
                       const std::shared_ptr<const world::Texture>& picture, PixelMeaning meaning) {
    return has(feature) ? pyramids.get(picture, meaning) : nullptr;
  };
  surface.colours = get(feature::kTextured, material.texture, colours);
  surface.normals = get(feature::kNormalMap, material.normal_map, PixelMeaning::kData);
  surface.roughnesses = get(feature::kRoughnessMap, material.roughness_map, PixelMeaning::kData);
  surface.metalnesses = get(feature::kMetalnessMap, material.metalness_map, PixelMeaning::kData);
  surface.glows = get(feature::kEmissiveMap, material.emissive_map, colours);
  return surface;
}

}  // namespace

bool hasGlowOfItsOwn(const world::Material& material) {
  return material.emissive_map && material.emissive_map != material.texture;
}

ClassicLight classicLight(const world::Material& material) {
  ClassicLight light;
  if (!material.lit) {
    light.emissive = material.diffuse.head<3>();
    return light;
  }
  light.ambient = material.ambient;
  (hasGlowOfItsOwn(material) ? light.glow : light.emissive) += material.emissive;
  light.diffuse = material.diffuse.head<3>();
  if (material.shininess > 0.0F && !material.specular.isZero()) {
    light.specular = material.specular;
    light.shininess = material.shininess;
  }
  return light;
}

std::vector<ItemSurface> itemSurfaces(const DrawList& draw_list, PyramidLibrary& pyramids) {
  std::vector<ItemSurface> surfaces(1);
  for (const DrawItem& item : draw_list.items()) {
    surfaces.push_back(surfaceOf(item, draw_list.isClassic(), pyramids));
  }
  return surfaces;
}

}  // namespace synthetic_dataset::render

#include "render/parts/part_surface.h"

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

PartSurface surfaceOf(const Part& part, bool is_classic, PyramidLibrary& pyramids) {
  const world::Material& material = *part.material;
  const PixelMeaning colours = is_classic ? PixelMeaning::kData : PixelMeaning::kColour;
  PartSurface surface;
  surface.shape = part.shape;
  surface.diffuse = linearFromSrgb(material.diffuse);
  if (is_classic) surface.diffuse.head<3>().setOnes();
  surface.scale = material.texture_scale;
  surface.offset = material.texture_offset;
  surface.roughness = material.roughness;
  surface.metalness = material.metalness;
  surface.alpha_threshold = material.alpha_threshold;
  const auto has = [&](SurfaceFeatures feature) { return (part.features & feature) != 0; };
  if (has(feature::kTinted)) surface.tints = &part.shape->colours;
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

std::vector<PartSurface> partSurfaces(const DrawList& parts, PyramidLibrary& pyramids) {
  std::vector<PartSurface> surfaces(1);
  for (const Part& part : parts.parts()) {
    surfaces.push_back(surfaceOf(part, parts.isClassic(), pyramids));
  }
  return surfaces;
}

}  // namespace synthetic_dataset::render

#include "world/material/material_source.h"

#include <memory>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

using Picture = std::shared_ptr<const Texture>;

Picture load(const std::optional<TextureReference>& reference, TextureLoader& textures,
             const MissingPicture& missing) {
  if (!reference) return nullptr;
  try {
    return textures.load(*reference);
  } catch (const Error& error) {
    missing(error.what());
    return nullptr;
  }
}

/// Combines the colour and opacity pictures. An opacity picture alone has white as its colour.
Picture loadColours(const MaterialSource& source, TextureLoader& textures,
                    const MissingPicture& missing) {
  Picture colours = load(source.texture, textures, missing);
  if (colours && load(source.factor, textures, missing)) {
    colours = textures.loadProduct(*source.texture, *source.factor);
  }
  const Picture opacity = load(source.opacity, textures, missing);
  if (colours && opacity) return textures.loadWithOpacity(*source.texture, *source.opacity);
  return colours ? colours : opacity;
}

}  // namespace

Material withPictures(const MaterialSource& source, TextureLoader& textures,
                      const MissingPicture& missing) {
  Material material = source.material;
  material.texture = loadColours(source, textures, missing);
  material.normal_map = load(source.normal_map, textures, missing);
  material.roughness_map = load(source.roughness_map, textures, missing);
  material.metalness_map = load(source.metalness_map, textures, missing);
  material.emissive_map = load(source.emissive_map, textures, missing);
  if (source.overlay) {
    material.overlay =
        std::make_shared<const Material>(withPictures(*source.overlay, textures, missing));
  }
  return material;
}

}  // namespace synthetic_dataset::world

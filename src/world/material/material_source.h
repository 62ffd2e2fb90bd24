#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/description.h"
#include "world/material/texture_loader.h"

namespace synthetic_dataset::world {

/// A material as a file describes it, its pictures not yet read.
struct MaterialSource {
  Material material;     ///< without pictures
  bool made_up = false;  ///< the file has none: this is the default
  std::optional<TextureReference> texture;
  std::optional<TextureReference> factor;   ///< multiplies the texture: a baked light, for one
  std::optional<TextureReference> opacity;  ///< its alpha takes the place of the texture's
  std::optional<TextureReference> normal_map;
  std::optional<TextureReference> roughness_map;
  std::optional<TextureReference> metalness_map;
  std::optional<TextureReference> emissive_map;
  std::shared_ptr<MaterialSource> overlay;  ///< of Material::overlay
};

/// Called for a picture that is missing or cannot be decoded; may throw.
using MissingPicture = std::function<void(const std::string& message)>;

/// Pointers to all pictures that it may name, always in the same order.
template <class Source>
[[nodiscard]] auto referencesOf(Source& source) {
  return std::vector{&source.texture,     &source.factor,        &source.opacity,
                     &source.normal_map,  &source.roughness_map, &source.metalness_map,
                     &source.emissive_map};
}

/// The material with its pictures. One that cannot be had is reported and left out: the colours and
/// numbers hold without it.
[[nodiscard]] Material withPictures(const MaterialSource& source, TextureLoader& textures,
                                    const MissingPicture& missing);

}  // namespace synthetic_dataset::world

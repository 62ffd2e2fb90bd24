#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/description.h"
#include "world/material/texture_loader.h"

namespace synthetic_dataset::world {

/// A material as a file describes it, before its pictures are read.
struct MaterialSource {
  Material material;        ///< without pictures
  bool is_default = false;  ///< the file has no material: this is the default
  std::optional<TextureReference> texture;
  std::optional<TextureReference> factor;   ///< multiplies the texture, as baked lighting does
  std::optional<TextureReference> opacity;  ///< its alpha replaces the texture's
  std::optional<TextureReference> normal_map;
  std::optional<TextureReference> roughness_map;
  std::optional<TextureReference> metalness_map;
  std::optional<TextureReference> emissive_map;
  std::shared_ptr<MaterialSource> overlay;  ///< becomes Material::overlay
};

/// Called for a picture that is missing or cannot be decoded; may throw.
using MissingPicture = std::function<void(const std::string& message)>;

/// Pointers to all picture references of a source, always in the same order.
template <class Source>
[[nodiscard]] auto referencesOf(Source& source) {
  return std::vector{&source.texture,     &source.factor,        &source.opacity,
                     &source.normal_map,  &source.roughness_map, &source.metalness_map,
                     &source.emissive_map};
}

/// The material with its pictures. A picture that cannot be loaded is reported and left out; the
/// colours and numbers still apply.
[[nodiscard]] Material withPictures(const MaterialSource& source, TextureLoader& textures,
                                    const MissingPicture& missing);

}  // namespace synthetic_dataset::world

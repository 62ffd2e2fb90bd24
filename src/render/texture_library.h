#pragma once

#include <memory>
#include <unordered_map>

#include "render/gl_object.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Uploads each texture once, with mipmaps, decoded from sRGB when it is read.
class TextureLibrary {
 public:
  explicit TextureLibrary(const GlFunctions& gl) : gl_(gl) {}

  /// The texture's OpenGL name; it lives as long as the library.
  [[nodiscard]] GLuint get(const std::shared_ptr<const world::Texture>& texture);

 private:
  const GlFunctions& gl_;
  std::unordered_map<std::shared_ptr<const world::Texture>, GlTexture> textures_;
};

}  // namespace synthetic_dataset::render

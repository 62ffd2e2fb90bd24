#pragma once

#include <map>
#include <memory>
#include <utility>

#include "render/gl/gl_object.h"
#include "render/pixels/light_picture.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// A picture as an OpenGL texture.
struct UploadedTexture {
  GlTexture texture;
  bool opaque = true;  ///< its alpha is 1 everywhere
};

/// Uploads each texture once for each meaning, with mipmaps.
class TextureLibrary {
 public:
  explicit TextureLibrary(const GlFunctions& gl) : gl_(gl) {}

  /// The reference is valid as long as the texture is used elsewhere, too (forgetUnused()).
  /// @throws Error if the texture's pixels do not have four channels
  [[nodiscard]] const UploadedTexture& get(const std::shared_ptr<const world::Texture>& texture,
                                           PixelMeaning meaning);

  /// Releases pictures that nothing else uses any more.
  void forgetUnused();

 private:
  const GlFunctions& gl_;
  std::map<std::pair<std::shared_ptr<const world::Texture>, PixelMeaning>, UploadedTexture>
      textures_;
};

}  // namespace synthetic_dataset::render

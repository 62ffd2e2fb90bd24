#include "render/shadow_maps.h"

#include <algorithm>

namespace synthetic_dataset::render {

ShadowMaps::ShadowMaps(const GlFunctions& gl, int size, int layers)
    : gl_(gl), size_(size), depth_(makeTexture(gl, GL_TEXTURE_2D_ARRAY)) {
  const GLuint name = depth_.name();
  // The shader's sampler needs a texture even where no light casts a shadow.
  gl.TextureStorage3D(name, 1, GL_DEPTH_COMPONENT32F, size, size, std::max(layers, 1));
  gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TextureParameteri(name, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  for (int layer = 0; layer < layers; ++layer) {
    layers_.push_back(makeFramebuffer(gl));
    gl.NamedFramebufferTextureLayer(layers_.back().name(), GL_DEPTH_ATTACHMENT, name, 0, layer);
    gl.NamedFramebufferDrawBuffers(layers_.back().name(), 0, nullptr);
  }
}

void ShadowMaps::begin(int layer) const {
  constexpr float kFarthest = 1.0F;
  const GLuint name = layers_[static_cast<std::size_t>(layer)].name();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, name);
  gl_.Viewport(0, 0, size_, size_);
  gl_.ClearNamedFramebufferfv(name, GL_DEPTH, 0, &kFarthest);
}

}  // namespace synthetic_dataset::render

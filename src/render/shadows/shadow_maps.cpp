#include "render/shadows/shadow_maps.h"

#include <algorithm>

#include <opencv2/core.hpp>

namespace synthetic_dataset::render {

namespace {

GlTexture makeLayers(const GlFunctions& gl, int size, int layers) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D_ARRAY);
  gl.TextureStorage3D(texture.name(), 1, GL_DEPTH_COMPONENT32F, size, size, layers);
  return texture;
}

}  // namespace

ShadowMaps::ShadowMaps(const GlFunctions& gl, int size, int layers)
    : gl_(gl),
      size_(size),
      layer_count_(
          std::max(layers, 1)),  // the shader's sampler needs a texture without shadows too
      depth_(makeLayers(gl, size, layer_count_)) {
  const GLuint name = depth_.name();
  gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TextureParameteri(name, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  for (int layer = 0; layer < layer_count_; ++layer) {
    layers_.push_back(makeFramebuffer(gl_));
    const GLuint framebuffer = layers_.back().name();
    gl_.NamedFramebufferTextureLayer(framebuffer, GL_DEPTH_ATTACHMENT, name, 0, layer);
    gl_.NamedFramebufferDrawBuffers(framebuffer, 0, nullptr);
  }
}

void ShadowMaps::begin(int layer) const { beginAgain(layer, {whole()}); }

void ShadowMaps::beginAgain(int layer, const std::vector<cv::Rect>& changed) const {
  constexpr float kFarthest = 1.0F;
  bind(layer);
  gl_.Enable(GL_SCISSOR_TEST);
  for (const cv::Rect& texels : changed) {
    gl_.Scissor(texels.x, texels.y, texels.width, texels.height);
    gl_.ClearNamedFramebufferfv(layers_[static_cast<std::size_t>(layer)].name(), GL_DEPTH, 0,
                                &kFarthest);
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

void ShadowMaps::keep(int layer) {
  if (kept_.name() == 0) kept_ = makeLayers(gl_, size_, layer_count_);
  copy(depth_, kept_, layer, whole());
}

void ShadowMaps::beginKept(int layer, const std::vector<cv::Rect>& changed) const {
  for (const cv::Rect& texels : changed) copy(kept_, depth_, layer, texels);
  bind(layer);
}

cv::Mat ShadowMaps::read(int layer, const cv::Rect& texels) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, layers_[static_cast<std::size_t>(layer)].name());
  cv::Mat depths(texels.size(), CV_32FC1);
  gl_.ReadPixels(texels.x, texels.y, texels.width, texels.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                 depths.data);
  return depths;
}

void ShadowMaps::bind(int layer) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, layers_[static_cast<std::size_t>(layer)].name());
  gl_.Viewport(0, 0, size_, size_);
}

void ShadowMaps::copy(const GlTexture& from, const GlTexture& to, int layer,
                      const cv::Rect& texels) const {
  gl_.CopyImageSubData(from.name(), GL_TEXTURE_2D_ARRAY, 0, texels.x, texels.y, layer, to.name(),
                       GL_TEXTURE_2D_ARRAY, 0, texels.x, texels.y, layer, texels.width,
                       texels.height, 1);
}

}  // namespace synthetic_dataset::render

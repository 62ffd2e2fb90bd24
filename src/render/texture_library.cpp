#include "render/texture_library.h"

#include <algorithm>
#include <iterator>

#include "synthetic_dataset/errors.h"
#include "world/material/picture_channels.h"

namespace synthetic_dataset::render {
namespace {

GLsizei mipmapLevels(int width, int height) {
  GLsizei levels = 1;
  for (int side = std::max(width, height); side > 1; side /= 2) ++levels;
  return levels;
}

UploadedTexture upload(const GlFunctions& gl, const world::Texture& texture, PixelMeaning meaning) {
  const cv::Mat& pixels = texture.pixels;
  if (pixels.empty() || pixels.type() != CV_8UC4) {
    throw Error(texture.file + ": a texture should have pixels of four channels");
  }
  UploadedTexture result{makeTexture(gl, GL_TEXTURE_2D), world::isOpaque(pixels)};
  const GLuint name = result.texture.name();
  gl.TextureStorage2D(name, mipmapLevels(pixels.cols, pixels.rows),
                      meaning == PixelMeaning::kColour ? GL_SRGB8_ALPHA8 : GL_RGBA8, pixels.cols,
                      pixels.rows);
  const cv::Mat packed = pixels.isContinuous() ? pixels : pixels.clone();
  gl.TextureSubImage2D(name, 0, 0, 0, pixels.cols, pixels.rows, GL_BGRA, GL_UNSIGNED_BYTE,
                       packed.data);
  gl.GenerateTextureMipmap(name);
  gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return result;
}

}  // namespace

const UploadedTexture& TextureLibrary::get(const std::shared_ptr<const world::Texture>& texture,
                                           PixelMeaning meaning) {
  const auto key = std::make_pair(texture, meaning);
  auto entry = textures_.find(key);
  if (entry == textures_.end()) {
    entry = textures_.emplace(key, upload(gl_, *texture, meaning)).first;
  }
  return entry->second;
}

void TextureLibrary::forgetUnused() {
  std::map<const world::Texture*, long> held_here;  // twice where it is colours and data
  for (const auto& [key, uploaded] : textures_) ++held_here[key.first.get()];
  for (auto entry = textures_.begin(); entry != textures_.end();) {
    const auto& texture = entry->first.first;
    const bool is_used = texture.use_count() > held_here.at(texture.get());
    entry = is_used ? std::next(entry) : textures_.erase(entry);
  }
}

}  // namespace synthetic_dataset::render

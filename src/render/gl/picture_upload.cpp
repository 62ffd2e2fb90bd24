#include "render/gl/picture_upload.h"

#include <algorithm>

namespace synthetic_dataset::render {
namespace {

GLsizei mipmapLevels(int width, int height) {
  GLsizei levels = 1;
  for (int side = std::max(width, height); side > 1; side /= 2) ++levels;
  return levels;
}

}  // namespace

GlTexture uploadPicture(const GlFunctions& gl, const cv::Mat& pixels, GLenum format,
                        Mipmaps mipmaps) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D);
  const GLuint name = texture.name();
  const bool has_mipmaps = mipmaps == Mipmaps::kAll;
  gl.TextureStorage2D(name, has_mipmaps ? mipmapLevels(pixels.cols, pixels.rows) : 1, format,
                      pixels.cols, pixels.rows);
  const cv::Mat packed = pixels.isContinuous() ? pixels : pixels.clone();
  gl.TextureSubImage2D(name, 0, 0, 0, pixels.cols, pixels.rows, GL_BGRA, GL_UNSIGNED_BYTE,
                       packed.data);
  if (has_mipmaps) gl.GenerateTextureMipmap(name);
  gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER,
                       has_mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return texture;
}

}  // namespace synthetic_dataset::render

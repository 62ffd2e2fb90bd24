#include "render/gl/picture_upload.h"

#include <cstddef>
#include <vector>

#include "render/pixels/mipmaps.h"

namespace synthetic_dataset::render {
namespace {

void uploadLevel(const GlFunctions& gl, GLuint texture, GLint level, const cv::Mat& pixels) {
  const cv::Mat packed = pixels.isContinuous() ? pixels : pixels.clone();
  gl.TextureSubImage2D(texture, level, 0, 0, packed.cols, packed.rows, GL_BGRA,
                       packed.depth() == CV_32F ? GL_FLOAT : GL_UNSIGNED_BYTE, packed.data);
}

GLenum formatOf(const cv::Mat& pixels, PixelMeaning meaning) {
  if (pixels.depth() == CV_32F) return GL_RGBA16F;
  return meaning == PixelMeaning::kColour ? GL_SRGB8_ALPHA8 : GL_RGBA8;
}

}  // namespace

GlTexture uploadPicture(const GlFunctions& gl, const cv::Mat& pixels, PixelMeaning meaning,
                        Mipmaps mipmaps) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D);
  const GLuint name = texture.name();
  std::vector<cv::Mat> levels{pixels};
  if (mipmaps == Mipmaps::kAll) {
    for (const cv::Mat& level : mipmapsOf(pixels, meaning)) levels.push_back(level);
  }
  const auto count = static_cast<GLsizei>(levels.size());
  gl.TextureStorage2D(name, count, formatOf(pixels, meaning), pixels.cols, pixels.rows);
  for (GLsizei i = 0; i < count; ++i) {
    uploadLevel(gl, name, i, levels[static_cast<std::size_t>(i)]);
  }
  gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER,
                       count > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TextureParameteri(name, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return texture;
}

}  // namespace synthetic_dataset::render

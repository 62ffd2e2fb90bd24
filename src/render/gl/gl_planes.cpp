#include "render/gl/gl_planes.h"

#include <string>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

GLenum attachment(std::size_t output) { return GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(output); }

}  // namespace

GlTexture makePlane(const GlFunctions& gl, GLenum format, int width, int height) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D);
  gl.TextureStorage2D(texture.name(), 1, format, width, height);
  // Whole numbers cannot be filtered: with OpenGL's defaults, shaders would read 0.
  gl.TextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

void attachPlanes(const GlFunctions& gl, const GlFramebuffer& framebuffer,
                  const std::vector<const GlTexture*>& planes, const GlTexture* depth,
                  GLenum depth_attachment) {
  const GLuint name = framebuffer.name();
  std::vector<GLenum> outputs(planes.size(), GL_NONE);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i]->name() == 0) continue;
    outputs[i] = attachment(i);
    gl.NamedFramebufferTexture(name, outputs[i], planes[i]->name(), 0);
  }
  if (depth != nullptr) gl.NamedFramebufferTexture(name, depth_attachment, depth->name(), 0);
  gl.NamedFramebufferDrawBuffers(name, static_cast<GLsizei>(outputs.size()), outputs.data());
  const GLenum status = gl.CheckNamedFramebufferStatus(name, GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw Error("OSMesa refuses a picture to draw into (status " + std::to_string(status) + ")");
  }
}

cv::Mat readPlane(const GlFunctions& gl, const GlFramebuffer& framebuffer, int output,
                  const cv::Rect& pixels, int type, GLenum format, GLenum component) {
  return readPlane(gl, framebuffer, output, pixels, {pixels}, type, format, component);
}

cv::Mat readPlane(const GlFunctions& gl, const GlFramebuffer& framebuffer, int output,
                  const cv::Rect& place, const std::vector<cv::Rect>& regions, int type,
                  GLenum format, GLenum component) {
  gl.NamedFramebufferReadBuffer(framebuffer.name(), attachment(static_cast<std::size_t>(output)));
  cv::Mat values(place.size(), type);
  gl.PixelStorei(GL_PACK_ROW_LENGTH, place.width);
  for (const cv::Rect& region : regions) {
    gl.ReadPixels(region.x, region.y, region.width, region.height, format, component,
                  values.ptr(region.y - place.y, region.x - place.x));
  }
  gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
  return values;
}

}  // namespace synthetic_dataset::render

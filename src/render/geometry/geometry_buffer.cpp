#include "render/geometry/geometry_buffer.h"

#include <array>

#include "render/gl/gl_planes.h"

namespace synthetic_dataset::render {
namespace {

/// The outputs of geometry.frag.
enum GeometryOutput { kItemsDepths, kBaseRoughness, kNormalMetalness, kFaces, kGlows };

GlTexture makeIf(bool wanted, const GlFunctions& gl, int width, int height) {
  return wanted ? makePlane(gl, GL_RGBA16F, width, height) : GlTexture();
}

}  // namespace

GeometryBuffer::GeometryBuffer(const GlFunctions& gl, int width, int height,
                               const GeometryPlanes& planes)
    : gl_(gl),
      width_(width),
      height_(height),
      parts_depths_(makePlane(gl, GL_RG32UI, width, height)),
      base_roughness_(makePlane(gl, GL_RGBA16F, width, height)),
      normal_metalness_(makePlane(gl, GL_RGBA16F, width, height)),
      faces_(makeIf(planes.faces, gl, width, height)),
      glows_(makeIf(planes.glows, gl, width, height)),
      depth_buffer_(makePlane(gl, GL_DEPTH32F_STENCIL8, width, height)),
      framebuffer_(makeFramebuffer(gl)) {
  attachPlanes(gl, framebuffer_,
               {&parts_depths_, &base_roughness_, &normal_metalness_, &faces_, &glows_},
               &depth_buffer_, GL_DEPTH_STENCIL_ATTACHMENT);
}

void GeometryBuffer::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, width_, height_);
}

void GeometryBuffer::begin() const {
  constexpr std::array<GLuint, 4> kNobody = {0, 0, 0, 0};
  const GLuint name = framebuffer_.name();
  bind();
  // So depth is 0 where there is nothing. What else such pixels hold is not looked at.
  gl_.ClearNamedFramebufferuiv(name, GL_COLOR, kItemsDepths, kNobody.data());
  gl_.ClearNamedFramebufferfi(name, GL_DEPTH_STENCIL, 0, 0.0F, 0);
}

void GeometryBuffer::copyTo(const GeometryBuffer& to, const cv::Rect& pixels) const {
  const auto copy = [&](const GlTexture& from, const GlTexture& into) {
    if (from.name() == 0) return;
    gl_.CopyImageSubData(from.name(), GL_TEXTURE_2D, 0, pixels.x, pixels.y, 0, into.name(),
                         GL_TEXTURE_2D, 0, pixels.x, pixels.y, 0, pixels.width, pixels.height, 1);
  };
  copy(parts_depths_, to.parts_depths_);
  copy(base_roughness_, to.base_roughness_);
  copy(normal_metalness_, to.normal_metalness_);
  copy(faces_, to.faces_);
  copy(glows_, to.glows_);
  copy(depth_buffer_, to.depth_buffer_);
}

GeometryImages GeometryBuffer::read(const cv::Rect& pixels) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const cv::Mat both =
      readPlane(gl_, framebuffer_, kItemsDepths, pixels, CV_32SC2, GL_RG_INTEGER, GL_UNSIGNED_INT);
  GeometryImages images{cv::Mat(pixels.size(), CV_32SC1), cv::Mat(pixels.size(), CV_32FC1), {}};
  const int* from = both.ptr<int>();
  int* items = images.items.ptr<int>();
  int* depth_bits = images.depth.ptr<int>();
  const std::size_t count = both.total();
  for (std::size_t i = 0; i < count; ++i) {
    items[i] = from[2 * i];
    depth_bits[i] = from[2 * i + 1];
  }
  return images;
}

SurfaceImages GeometryBuffer::readSurfaces(const cv::Rect& place,
                                           const std::vector<cv::Rect>& regions) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const auto readIf = [&](const GlTexture& plane, GeometryOutput output) {
    if (plane.name() == 0) return cv::Mat();
    return readPlane(gl_, framebuffer_, output, place, regions, CV_16UC4, GL_RGBA, GL_HALF_FLOAT);
  };
  return {readIf(base_roughness_, kBaseRoughness), readIf(normal_metalness_, kNormalMetalness),
          readIf(faces_, kFaces), readIf(glows_, kGlows)};
}

cv::Mat GeometryBuffer::readStencil(const cv::Rect& pixels) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  cv::Mat bits(pixels.size(), CV_8UC1);
  gl_.ReadPixels(pixels.x, pixels.y, pixels.width, pixels.height, GL_STENCIL_INDEX,
                 GL_UNSIGNED_BYTE, bits.data);
  return bits;
}

}  // namespace synthetic_dataset::render

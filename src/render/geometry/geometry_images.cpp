#include "render/geometry/geometry_images.h"

#include <cstddef>

namespace synthetic_dataset::render {
namespace {

/// The outputs of geometry.frag.
enum GeometryOutput : std::size_t {
  kItemsDepths,
  kBaseRoughness,
  kNormalMetalness,
  kFaceNormals,
  kGlows
};

}  // namespace

Framebuffer makeGeometryBuffer(const GlFunctions& gl, const cv::Size& size,
                               const GeometryPlanes& planes) {
  const GLenum faces = planes.faces ? GL_RGBA16F : GL_NONE;
  const GLenum glows = planes.glows ? GL_RGBA16F : GL_NONE;
  return {gl, size, {GL_RG32UI, GL_RGBA16F, GL_RGBA16F, faces, glows}, GL_DEPTH32F_STENCIL8};
}

void beginGeometry(const Framebuffer& buffer) {
  buffer.bind();
  // Makes depth 0 where there is nothing; the other values of such pixels are not used.
  buffer.clearToZero(kItemsDepths);
  buffer.clearDepth();
}

GeometryImages readGeometry(const Framebuffer& buffer, const cv::Rect& pixels) {
  const cv::Mat both = buffer.read(kItemsDepths, pixels);
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

SurfaceImages readSurfaces(const Framebuffer& buffer, const cv::Rect& place,
                           const std::vector<cv::Rect>& regions) {
  return {buffer.read(kBaseRoughness, place, regions),
          buffer.read(kNormalMetalness, place, regions), buffer.read(kFaceNormals, place, regions),
          buffer.read(kGlows, place, regions)};
}

}  // namespace synthetic_dataset::render

#include "render/gl/render_target.h"

#include <array>

#include "render/gl/gl_planes.h"

namespace synthetic_dataset::render {
namespace {

/// The label shader's outputs.
enum LabelOutput { kIds, kDepths, kLinks, kNormals };

}  // namespace

LabelTarget::LabelTarget(const GlFunctions& gl, int width, int height, const LabelPlanes& planes)
    : gl_(gl),
      width_(width),
      height_(height),
      ids_(makePlane(gl, GL_R32UI, width, height)),
      depth_(makePlane(gl, GL_R32F, width, height)),
      depth_buffer_(makePlane(gl, GL_DEPTH_COMPONENT32F, width, height)),
      framebuffer_(makeFramebuffer(gl)) {
  if (planes.links) links_ = makePlane(gl, GL_R32UI, width, height);
  if (planes.normals) normals_ = makePlane(gl, GL_RGBA32F, width, height);
  attachPlanes(gl, framebuffer_, {&ids_, &depth_, &links_, &normals_}, &depth_buffer_);
}

void LabelTarget::begin(const cv::Size& image) const {
  constexpr std::array<GLuint, 4> kNobody = {0, 0, 0, 0};
  constexpr std::array<float, 4> kNothing = {0.0F, 0.0F, 0.0F, 0.0F};
  const GLuint name = framebuffer_.name();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, name);
  gl_.Viewport(0, 0, image.width, image.height);
  gl_.Enable(GL_SCISSOR_TEST);  // for the clearing, too
  gl_.Scissor(0, 0, image.width, image.height);
  gl_.ClearNamedFramebufferuiv(name, GL_COLOR, kIds, kNobody.data());
  gl_.ClearNamedFramebufferfv(name, GL_COLOR, kDepths, kNothing.data());
  if (links_.name() != 0) gl_.ClearNamedFramebufferuiv(name, GL_COLOR, kLinks, kNobody.data());
  if (normals_.name() != 0) gl_.ClearNamedFramebufferfv(name, GL_COLOR, kNormals, kNothing.data());
  gl_.ClearNamedFramebufferfv(name, GL_DEPTH, 0, kNothing.data());
}

LabelImages LabelTarget::read(const cv::Size& image) const {
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const cv::Rect all(cv::Point(), image);
  const auto plane = [&](int output, int type, GLenum format, GLenum component) {
    return readPlane(gl_, framebuffer_, output, all, type, format, component);
  };
  LabelImages images;
  images.ids = plane(kIds, CV_32SC1, GL_RED_INTEGER, GL_UNSIGNED_INT);
  images.depth = plane(kDepths, CV_32FC1, GL_RED, GL_FLOAT);
  if (links_.name() != 0) {
    images.links = plane(kLinks, CV_32SC1, GL_RED_INTEGER, GL_UNSIGNED_INT);
  }
  if (normals_.name() != 0) images.normals = plane(kNormals, CV_32FC3, GL_RGB, GL_FLOAT);
  return images;
}

MaskTarget::MaskTarget(const GlFunctions& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      mask_(makePlane(gl, GL_R8, width, height)),
      framebuffer_(makeFramebuffer(gl)) {
  attachPlanes(gl, framebuffer_, {&mask_}, nullptr);
}

void MaskTarget::begin(const cv::Size& image, const cv::Rect& region) const {
  constexpr std::array<float, 4> kNothing = {0.0F, 0.0F, 0.0F, 0.0F};
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, image.width, image.height);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(region.x, region.y, region.width, region.height);
  gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kNothing.data());
}

cv::Mat MaskTarget::read(const cv::Rect& region) const {
  gl_.Disable(GL_SCISSOR_TEST);
  return readPlane(gl_, framebuffer_, 0, region, CV_8UC1, GL_RED, GL_UNSIGNED_BYTE);
}

}  // namespace synthetic_dataset::render

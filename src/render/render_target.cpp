#include "render/render_target.h"

#include <array>
#include <string>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

GlTexture makePlane(const GlFunctions& gl, GLenum format, int width, int height) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D);
  gl.TextureStorage2D(texture.name(), 1, format, width, height);
  return texture;
}

GlTexture makeSamples(const GlFunctions& gl, GLenum format, int width, int height, int samples) {
  if (samples == 1) return makePlane(gl, format, width, height);
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D_MULTISAMPLE);
  gl.TextureStorage2DMultisample(texture.name(), samples, format, width, height, GL_TRUE);
  return texture;
}

void checkComplete(const GlFunctions& gl, const GlFramebuffer& framebuffer) {
  const GLenum status = gl.CheckNamedFramebufferStatus(framebuffer.name(), GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw Error("OSMesa refuses a picture to draw into (status " + std::to_string(status) + ")");
  }
}

}  // namespace

ColourTarget::ColourTarget(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl),
      width_(width),
      height_(height),
      samples_colour_(makeSamples(gl, GL_SRGB8_ALPHA8, width, height, samples)),
      samples_depth_(makeSamples(gl, GL_DEPTH_COMPONENT32F, width, height, samples)),
      resolved_colour_(makePlane(gl, GL_SRGB8_ALPHA8, width, height)),
      samples_(makeFramebuffer(gl)),
      resolved_(makeFramebuffer(gl)) {
  gl.NamedFramebufferTexture(samples_.name(), GL_COLOR_ATTACHMENT0, samples_colour_.name(), 0);
  gl.NamedFramebufferTexture(samples_.name(), GL_DEPTH_ATTACHMENT, samples_depth_.name(), 0);
  gl.NamedFramebufferTexture(resolved_.name(), GL_COLOR_ATTACHMENT0, resolved_colour_.name(), 0);
  checkComplete(gl, samples_);
  checkComplete(gl, resolved_);
}

void ColourTarget::begin(const float background[3]) const {
  constexpr float kFarthest = 0.0F;  // depth is reversed
  const std::array<float, 4> colour = {background[0], background[1], background[2], 1.0F};
  gl_.BindFramebuffer(GL_FRAMEBUFFER, samples_.name());
  gl_.Viewport(0, 0, width_, height_);
  gl_.ClearNamedFramebufferfv(samples_.name(), GL_COLOR, 0, colour.data());
  gl_.ClearNamedFramebufferfv(samples_.name(), GL_DEPTH, 0, &kFarthest);
}

cv::Mat ColourTarget::read() const {
  gl_.BlitNamedFramebuffer(samples_.name(), resolved_.name(), 0, 0, width_, height_, 0, 0, width_,
                           height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  gl_.NamedFramebufferReadBuffer(resolved_.name(), GL_COLOR_ATTACHMENT0);
  cv::Mat image(height_, width_, CV_8UC3);
  gl_.ReadPixels(0, 0, width_, height_, GL_BGR, GL_UNSIGNED_BYTE, image.data);
  return image;
}

LabelTarget::LabelTarget(const GlFunctions& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      ids_(makePlane(gl, GL_R32UI, width, height)),
      depth_(makePlane(gl, GL_R32F, width, height)),
      depth_buffer_(makePlane(gl, GL_DEPTH_COMPONENT32F, width, height)),
      framebuffer_(makeFramebuffer(gl)) {
  constexpr std::array<GLenum, 2> kOutputs = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  const GLuint name = framebuffer_.name();
  gl.NamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, ids_.name(), 0);
  gl.NamedFramebufferTexture(name, GL_COLOR_ATTACHMENT1, depth_.name(), 0);
  gl.NamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth_buffer_.name(), 0);
  gl.NamedFramebufferDrawBuffers(name, static_cast<GLsizei>(kOutputs.size()), kOutputs.data());
  checkComplete(gl, framebuffer_);
}

void LabelTarget::begin() const {
  constexpr std::array<GLuint, 4> kNobody = {0, 0, 0, 0};
  constexpr std::array<float, 4> kNothing = {0.0F, 0.0F, 0.0F, 0.0F};
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, width_, height_);
  gl_.ClearNamedFramebufferuiv(framebuffer_.name(), GL_COLOR, 0, kNobody.data());
  gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 1, kNothing.data());
  gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, kNothing.data());
}

LabelImages LabelTarget::read() const {
  LabelImages images{cv::Mat(height_, width_, CV_32SC1), cv::Mat(height_, width_, CV_32FC1)};
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.NamedFramebufferReadBuffer(framebuffer_.name(), GL_COLOR_ATTACHMENT0);
  gl_.ReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_INT, images.ids.data);
  gl_.NamedFramebufferReadBuffer(framebuffer_.name(), GL_COLOR_ATTACHMENT1);
  gl_.ReadPixels(0, 0, width_, height_, GL_RED, GL_FLOAT, images.depth.data);
  return images;
}

}  // namespace synthetic_dataset::render

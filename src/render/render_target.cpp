#include "render/render_target.h"

#include <array>
#include <string>

#include "render/srgb.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

GlTexture makePlane(const GlFunctions& gl, GLenum format, int width, int height) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D);
  gl.TextureStorage2D(texture.name(), 1, format, width, height);
  return texture;
}

GlTexture makeSamplePlane(const GlFunctions& gl, GLenum format, int width, int height,
                          int samples) {
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

/// The label shader's outputs.
enum LabelOutput { kIds, kDepths, kLinks, kNormals, kSlopes };

GLenum attachment(std::size_t output) { return GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(output); }

}  // namespace

ColourTarget::ColourTarget(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl),
      width_(width),
      height_(height),
      sample_count_(samples),
      samples_colour_(makeSamplePlane(gl, GL_RGBA16F, width, height, samples)),
      samples_depth_(makeSamplePlane(gl, GL_DEPTH_COMPONENT32F, width, height, samples)),
      resolved_colour_(makePlane(gl, GL_RGBA16F, width, height)),
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
  bind();
  gl_.ClearNamedFramebufferfv(samples_.name(), GL_COLOR, 0, colour.data());
  gl_.ClearNamedFramebufferfv(samples_.name(), GL_DEPTH, 0, &kFarthest);
}

void ColourTarget::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, samples_.name());
  gl_.Viewport(0, 0, width_, height_);
}

ColourSamples ColourTarget::makeSamples() const {
  return {makeSamplePlane(gl_, GL_RGBA16F, width_, height_, sample_count_),
          makeSamplePlane(gl_, GL_DEPTH_COMPONENT32F, width_, height_, sample_count_)};
}

void ColourTarget::keep(const ColourSamples& to) const {
  const cv::Rect all(0, 0, width_, height_);
  copySamples(samples_colour_, to.colour, all);
  copySamples(samples_depth_, to.depth, all);
}

void ColourTarget::restore(const ColourSamples& from, const cv::Rect& pixels) const {
  copySamples(from.colour, samples_colour_, pixels);
  copySamples(from.depth, samples_depth_, pixels);
}

void ColourTarget::copySamples(const GlTexture& from, const GlTexture& to,
                               const cv::Rect& pixels) const {
  const GLenum kind = sample_count_ == 1 ? GL_TEXTURE_2D : GL_TEXTURE_2D_MULTISAMPLE;
  gl_.CopyImageSubData(from.name(), kind, 0, pixels.x, pixels.y, 0, to.name(), kind, 0, pixels.x,
                       pixels.y, 0, pixels.width, pixels.height, 1);
}

cv::Mat ColourTarget::read() const {
  gl_.BlitNamedFramebuffer(samples_.name(), resolved_.name(), 0, 0, width_, height_, 0, 0, width_,
                           height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  gl_.NamedFramebufferReadBuffer(resolved_.name(), GL_COLOR_ATTACHMENT0);
  cv::Mat light(height_, width_, CV_16UC4);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_HALF_FLOAT, light.data);
  return srgbFromLinear(light);
}

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
  if (planes.slopes) slopes_ = makePlane(gl, GL_RG32F, width, height);
  const std::array<const GlTexture*, 5> textures = {&ids_, &depth_, &links_, &normals_, &slopes_};
  std::array<GLenum, 5> outputs{};
  const GLuint name = framebuffer_.name();
  for (std::size_t i = 0; i < textures.size(); ++i) {
    outputs[i] = GL_NONE;
    if (textures[i]->name() == 0) continue;
    outputs[i] = attachment(i);
    gl.NamedFramebufferTexture(name, outputs[i], textures[i]->name(), 0);
  }
  gl.NamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth_buffer_.name(), 0);
  gl.NamedFramebufferDrawBuffers(name, static_cast<GLsizei>(outputs.size()), outputs.data());
  checkComplete(gl, framebuffer_);
}

void LabelTarget::begin() const {
  constexpr std::array<GLuint, 4> kNobody = {0, 0, 0, 0};
  constexpr std::array<float, 4> kNothing = {0.0F, 0.0F, 0.0F, 0.0F};
  const GLuint name = framebuffer_.name();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, name);
  gl_.Viewport(0, 0, width_, height_);
  gl_.ClearNamedFramebufferuiv(name, GL_COLOR, kIds, kNobody.data());
  gl_.ClearNamedFramebufferfv(name, GL_COLOR, kDepths, kNothing.data());
  if (links_.name() != 0) gl_.ClearNamedFramebufferuiv(name, GL_COLOR, kLinks, kNobody.data());
  if (normals_.name() != 0) gl_.ClearNamedFramebufferfv(name, GL_COLOR, kNormals, kNothing.data());
  if (slopes_.name() != 0) gl_.ClearNamedFramebufferfv(name, GL_COLOR, kSlopes, kNothing.data());
  gl_.ClearNamedFramebufferfv(name, GL_DEPTH, 0, kNothing.data());
}

LabelImages LabelTarget::read() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const auto plane = [this](int output, int type, GLenum format, GLenum component) {
    gl_.NamedFramebufferReadBuffer(framebuffer_.name(), attachment(static_cast<unsigned>(output)));
    cv::Mat pixels(height_, width_, type);
    gl_.ReadPixels(0, 0, width_, height_, format, component, pixels.data);
    return pixels;
  };
  LabelImages images;
  images.ids = plane(kIds, CV_32SC1, GL_RED_INTEGER, GL_UNSIGNED_INT);
  images.depth = plane(kDepths, CV_32FC1, GL_RED, GL_FLOAT);
  if (links_.name() != 0) {
    images.links = plane(kLinks, CV_32SC1, GL_RED_INTEGER, GL_UNSIGNED_INT);
  }
  if (normals_.name() != 0) images.normals = plane(kNormals, CV_32FC3, GL_RGB, GL_FLOAT);
  if (slopes_.name() != 0) images.slopes = plane(kSlopes, CV_32FC2, GL_RG, GL_FLOAT);
  return images;
}

MaskTarget::MaskTarget(const GlFunctions& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      mask_(makePlane(gl, GL_R8, width, height)),
      framebuffer_(makeFramebuffer(gl)) {
  gl.NamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, mask_.name(), 0);
  checkComplete(gl, framebuffer_);
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
  gl_.NamedFramebufferReadBuffer(framebuffer_.name(), GL_COLOR_ATTACHMENT0);
  cv::Mat mask(region.size(), CV_8UC1);
  gl_.ReadPixels(region.x, region.y, region.width, region.height, GL_RED, GL_UNSIGNED_BYTE,
                 mask.data);
  return mask;
}

}  // namespace synthetic_dataset::render

#include "render/gl/framebuffer.h"

#include <algorithm>
#include <string>
#include <utility>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

GLenum attachment(std::size_t output) { return GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(output); }

/// How pixels of a sized format are read.
struct PixelType {
  GLenum sized;  ///< the sized format
  int type;      ///< of cv::Mat
  GLenum format;
  GLenum component;
};

constexpr std::array<PixelType, 6> kPixelTypes = {
    {{GL_R8, CV_8UC1, GL_RED, GL_UNSIGNED_BYTE},
     {GL_R32F, CV_32FC1, GL_RED, GL_FLOAT},
     {GL_R32UI, CV_32SC1, GL_RED_INTEGER, GL_UNSIGNED_INT},
     {GL_RG32UI, CV_32SC2, GL_RG_INTEGER, GL_UNSIGNED_INT},
     {GL_RGBA16F, CV_16UC4, GL_RGBA, GL_HALF_FLOAT},
     {GL_RGBA32F, CV_32FC3, GL_RGB, GL_FLOAT}}};

std::vector<GlTexture> makeOutputs(const GlFunctions& gl, const cv::Size& size,
                                   const std::vector<GLenum>& formats) {
  std::vector<GlTexture> outputs;
  for (const GLenum format : formats) {
    outputs.push_back(format == GL_NONE ? GlTexture()
                                        : makePlane(gl, format, size.width, size.height));
  }
  return outputs;
}

}  // namespace

GlTexture makePlane(const GlFunctions& gl, GLenum format, int width, int height) {
  GlTexture texture = makeTexture(gl, GL_TEXTURE_2D);
  gl.TextureStorage2D(texture.name(), 1, format, width, height);
  // Integers cannot be filtered: with OpenGL's defaults, shaders would read 0.
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
    throw Error("Mesa refuses to draw into a picture (status " + std::to_string(status) + ")");
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

Framebuffer::Framebuffer(const GlFunctions& gl, const cv::Size& size, std::vector<GLenum> formats,
                         GLenum depth)
    : gl_(gl),
      size_(size),
      formats_(std::move(formats)),
      outputs_(makeOutputs(gl, size, formats_)),
      depth_format_(depth),
      framebuffer_(makeFramebuffer(gl)) {
  if (depth != GL_NONE) depth_ = makePlane(gl, depth, size.width, size.height);
  attach(depth_);
}

Framebuffer::Framebuffer(const Framebuffer& with_depth, std::vector<GLenum> formats)
    : gl_(with_depth.gl_),
      size_(with_depth.size_),
      formats_(std::move(formats)),
      outputs_(makeOutputs(gl_, size_, formats_)),
      depth_format_(with_depth.depth_format_),
      framebuffer_(makeFramebuffer(gl_)) {
  attach(with_depth.depth_);
}

void Framebuffer::attach(const GlTexture& depth) const {
  std::vector<const GlTexture*> planes;
  for (const GlTexture& each : outputs_) planes.push_back(&each);
  attachPlanes(gl_, framebuffer_, planes, depth.name() == 0 ? nullptr : &depth,
               hasStencil() ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT);
}

void Framebuffer::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, size_.width, size_.height);
}

void Framebuffer::bind(const cv::Size& image, const cv::Rect& pixels) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, image.width, image.height);
  gl_.Enable(GL_SCISSOR_TEST);  // for clearing, too
  gl_.Scissor(pixels.x, pixels.y, pixels.width, pixels.height);
}

void Framebuffer::clear(std::size_t output, const std::array<float, 4>& value) const {
  if (outputs_[output].name() == 0) return;
  gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, static_cast<GLint>(output),
                              value.data());
}

void Framebuffer::clearToZero(std::size_t output) const {
  if (outputs_[output].name() == 0) return;
  constexpr std::array<GLuint, 4> kZero = {0, 0, 0, 0};
  gl_.ClearNamedFramebufferuiv(framebuffer_.name(), GL_COLOR, static_cast<GLint>(output),
                               kZero.data());
}

void Framebuffer::clearDepth() const {
  constexpr float kFarthest = 0.0F;
  if (hasStencil()) {
    gl_.ClearNamedFramebufferfi(framebuffer_.name(), GL_DEPTH_STENCIL, 0, kFarthest, 0);
  } else {
    gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &kFarthest);
  }
}

cv::Mat Framebuffer::read(std::size_t output, const cv::Rect& pixels) const {
  return read(output, pixels, {pixels});
}

cv::Mat Framebuffer::read(std::size_t output, const cv::Rect& place,
                          const std::vector<cv::Rect>& regions) const {
  if (outputs_[output].name() == 0) return {};
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const PixelType& pixel =
      *std::find_if(kPixelTypes.begin(), kPixelTypes.end(),
                    [&](const PixelType& each) { return each.sized == formats_[output]; });
  return readPlane(gl_, framebuffer_, static_cast<int>(output), place, regions, pixel.type,
                   pixel.format, pixel.component);
}

cv::Mat Framebuffer::readStencil(const cv::Rect& pixels) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  cv::Mat bits(pixels.size(), CV_8UC1);
  gl_.ReadPixels(pixels.x, pixels.y, pixels.width, pixels.height, GL_STENCIL_INDEX,
                 GL_UNSIGNED_BYTE, bits.data);
  return bits;
}

void Framebuffer::copyTo(const Framebuffer& to, const cv::Rect& pixels) const {
  const auto copy = [&](const GlTexture& from, const GlTexture& into) {
    if (from.name() == 0) return;
    gl_.CopyImageSubData(from.name(), GL_TEXTURE_2D, 0, pixels.x, pixels.y, 0, into.name(),
                         GL_TEXTURE_2D, 0, pixels.x, pixels.y, 0, pixels.width, pixels.height, 1);
  };
  for (std::size_t i = 0; i < outputs_.size(); ++i) copy(outputs_[i], to.outputs_[i]);
  copy(depth_, to.depth_);
}

const Framebuffer& framebufferFor(const GlFunctions& gl, const cv::Size& image,
                                  const std::vector<GLenum>& formats, GLenum depth,
                                  std::optional<Framebuffer>& framebuffer) {
  const cv::Size held = framebuffer ? framebuffer->size() : cv::Size();
  if (held.width < image.width || held.height < image.height) {
    framebuffer.reset();  // before the next one needs memory
    const cv::Size size(std::max(image.width, held.width), std::max(image.height, held.height));
    framebuffer.emplace(gl, size, formats, depth);
  }
  return *framebuffer;
}

}  // namespace synthetic_dataset::render

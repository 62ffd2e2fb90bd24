#include "floor_picture.h"

#include "render/gl/framebuffer.h"

// After glcorearb.h, as it defines the same names in an older version.
#include <GL/osmesa.h>

namespace synthetic_dataset::benchmark {
namespace {

template <class Function>
Function entryPoint(const char* name) {
  return reinterpret_cast<Function>(OSMesaGetProcAddress(name));
}

}  // namespace

FloorPicture::FloorPicture(const render::GlFunctions& gl, const cv::Size& size, GLsizei samples)
    : gl_(gl),
      size_(size),
      samples_(samples),
      colour_(plane(GL_RGBA8)),
      identifiers_(plane(GL_R32UI)),
      depth_(plane(GL_DEPTH_COMPONENT32F)),
      framebuffer_(render::makeFramebuffer(gl)) {
  render::attachPlanes(gl_, framebuffer_, {&colour_, &identifiers_}, &depth_);
}

render::GlTexture FloorPicture::plane(GLenum format) const {
  if (samples_ == 1) return render::makePlane(gl_, format, size_.width, size_.height);
  static const auto kStorage =
      entryPoint<PFNGLTEXTURESTORAGE2DMULTISAMPLEPROC>("glTextureStorage2DMultisample");
  render::GlTexture texture = render::makeTexture(gl_, GL_TEXTURE_2D_MULTISAMPLE);
  kStorage(texture.name(), samples_, format, size_.width, size_.height, GL_TRUE);
  return texture;
}

void FloorPicture::begin() const {
  constexpr float kGrey[] = {0.7F, 0.7F, 0.7F, 1.0F};
  constexpr GLuint kNobody[] = {0, 0, 0, 0};
  constexpr float kFarthest = 0.0F;
  gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kGrey);
  gl_.ClearNamedFramebufferuiv(framebuffer_.name(), GL_COLOR, 1, kNobody);
  gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &kFarthest);
  bind();
}

void FloorPicture::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, size_.width, size_.height);
}

void FloorPicture::resolveTo(const FloorPicture& one) const {
  static const auto kDrawBuffer =
      entryPoint<PFNGLNAMEDFRAMEBUFFERDRAWBUFFERPROC>("glNamedFramebufferDrawBuffer");
  static const auto kBlit = entryPoint<PFNGLBLITNAMEDFRAMEBUFFERPROC>("glBlitNamedFramebuffer");
  for (const GLenum output : {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1}) {
    gl_.NamedFramebufferReadBuffer(framebuffer_.name(), output);
    kDrawBuffer(one.framebuffer_.name(), output);
    kBlit(framebuffer_.name(), one.framebuffer_.name(), 0, 0, size_.width, size_.height, 0, 0,
          size_.width, size_.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  one.bind();
}

cv::Mat FloorPicture::readColour() const {
  return render::readPlane(gl_, framebuffer_, 0, {{}, size_}, CV_8UC3, GL_BGR, GL_UNSIGNED_BYTE);
}

cv::Mat FloorPicture::readIdentifiers() const {
  return render::readPlane(gl_, framebuffer_, 1, {{}, size_}, CV_32SC1, GL_RED_INTEGER,
                           GL_UNSIGNED_INT);
}

}  // namespace synthetic_dataset::benchmark

#include "render/overlay/overlay_target.h"

#include <array>

#include "render/gl/gl_planes.h"

namespace synthetic_dataset::render {

OverlayTarget::OverlayTarget(const GlFunctions& gl, int width, int height,
                             const GeometryBuffer& geometry)
    : gl_(gl),
      width_(width),
      height_(height),
      light_(makePlane(gl, GL_RGBA16F, width, height)),
      framebuffer_(makeFramebuffer(gl)) {
  attachPlanes(gl, framebuffer_, {&light_}, &geometry.depthBuffer());
}

void OverlayTarget::begin(const cv::Rect& pixels) const {
  constexpr std::array<float, 4> kAllPasses = {0.0F, 0.0F, 0.0F, 1.0F};
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, width_, height_);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(pixels.x, pixels.y, pixels.width, pixels.height);
  gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kAllPasses.data());
}

cv::Mat OverlayTarget::read(const cv::Rect& pixels) const {
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  return readPlane(gl_, framebuffer_, 0, pixels, CV_16UC4, GL_RGBA, GL_HALF_FLOAT);
}

}  // namespace synthetic_dataset::render

#include "render/overlay/sky_panorama.h"

#include "render/gl/gl_planes.h"
#include "render/overlay/sky_program.h"

namespace synthetic_dataset::render {
namespace {

/// A clear sky changes slowly.
int skyRows(const world::Sky& sky) { return sky.cloud_humidity > 0.0 ? 512 : 256; }

}  // namespace

SkyPanorama::SkyPanorama(const GlFunctions& gl, const world::Sky& sky)
    : gl_(gl),
      program_(makeSkyProgram(gl, sky, "#define PANORAMA\n")),
      drawing_(gl),
      size_(2 * skyRows(sky), skyRows(sky)),
      light_(makePlane(gl, GL_RGBA16F, size_.width, size_.height)),
      framebuffer_(makeFramebuffer(gl)) {
  attachPlanes(gl, framebuffer_, {&light_}, nullptr);
  program_.set("picture_size", Eigen::Vector4f(static_cast<float>(size_.width),
                                               static_cast<float>(size_.height), 0.0F, 0.0F));
}

cv::Mat SkyPanorama::draw(const Eigen::Vector3d& sun) const {
  const cv::Rect all({}, size_);
  setSun(program_, sun);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_.Viewport(0, 0, all.width, all.height);
  drawing_.draw(program_, {all}, size_);
  return readPlane(gl_, framebuffer_, 0, all, CV_16UC4, GL_RGBA, GL_HALF_FLOAT);
}

}  // namespace synthetic_dataset::render

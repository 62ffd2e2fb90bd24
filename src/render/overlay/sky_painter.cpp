#include "render/overlay/sky_painter.h"

#include "render/overlay/shader_macros.h"
#include "render/overlay/sky_program.h"

namespace synthetic_dataset::render {

SkyPainter::SkyPainter(const GlFunctions& gl, const world::Sky& sky,
                       const std::vector<world::Light>& lights, bool encoded)
    : sky_(sky), program_(makeSkyProgram(gl, sky, encoded ? kEncodedMacro : "")), drawing_(gl) {
  setLights(lights);
}

void SkyPainter::setLights(const std::vector<world::Light>& lights) const {
  setSun(program_, sunDirection(sky_, lights));
}

void SkyPainter::paint(const View& view, float exposure,
                       const std::vector<cv::Rect>& regions) const {
  const Intrinsics& k = view.camera.intrinsics();
  program_.set("exposure", exposure);
  program_.set("exposure_later", exposure);
  program_.set("world_from_camera", Eigen::Matrix4f(view.X_WC.matrix().cast<float>()));
  program_.set("intrinsics",
               Eigen::Vector4f(Eigen::Vector4d(k.fx, k.fy, k.cx, k.cy).cast<float>()));
  drawing_.draw(program_, regions, {view.camera.width(), view.camera.height()});
}

}  // namespace synthetic_dataset::render

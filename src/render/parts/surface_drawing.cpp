#include "render/parts/surface_drawing.h"

#include "render/gl/texture_units.h"

namespace synthetic_dataset::render {

void bindHoles(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item) {
  const world::Material& material = *item.material;
  Eigen::Vector4f placement;
  placement << material.texture_scale, material.texture_offset;
  program.set("texture_placement", placement);
  program.set("alpha_threshold", material.alpha_threshold);
  if (item.textures.diffuse != 0) gl.BindTextureUnit(kDiffuseUnit, item.textures.diffuse);
}

SurfaceFeatures featuresOf(const View& view) {
  return view.near_limit ? feature::kNearLimit : SurfaceFeatures{0};
}

void drawSurface(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item,
                 const View& view, const Pose& X_WL) {
  if (item.material->double_sided) {
    gl.Disable(GL_CULL_FACE);
  } else {
    gl.Enable(GL_CULL_FACE);
  }
  const Pose X_CV = view.X_WC.inverse() * X_WL * item.X_LV;
  program.use();
  program.set("clip_from_camera", Eigen::Matrix4f(clipFromCamera(view.camera).cast<float>()));
  program.set("camera_from_mesh", Eigen::Matrix4f(X_CV.matrix().cast<float>()));
  if (view.near_limit) {
    Eigen::Vector4f limit;
    limit << view.near_limit->axis_C.cast<float>(), static_cast<float>(view.near_limit->reach);
    program.set("near_limit", limit);
  }
  bindHoles(gl, program, item);
  item.mesh->draw();
}

}  // namespace synthetic_dataset::render

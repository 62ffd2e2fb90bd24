#include "render/parts/surface_drawing.h"

#include <algorithm>

#include "render/gl/shader_program.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {

float reflectance(const world::Material& material) {
  const float strength = std::clamp(material.specular.maxCoeff(), 0.0F, 1.0F);
  return 0.16F * strength * strength;
}

void setMaterial(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item,
                 world::Simulator simulator) {
  const world::Material& material = *item.material;
  Eigen::Vector4f diffuse = linearFromSrgb(material.diffuse);
  if (simulator == world::Simulator::kClassic) diffuse.head<3>().setOnes();
  program.set("diffuse", diffuse);
  program.set("roughness", material.roughness);
  program.set("metalness", material.metalness);
  const ItemTextures& textures = item.textures;
  if (textures.normal != 0) gl.BindTextureUnit(kNormalUnit, textures.normal);
  if (textures.roughness != 0) gl.BindTextureUnit(kRoughnessUnit, textures.roughness);
  if (textures.metalness != 0) gl.BindTextureUnit(kMetalnessUnit, textures.metalness);
  if (textures.emissive != 0) gl.BindTextureUnit(kEmissiveUnit, textures.emissive);
}

void bindHoles(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item) {
  const world::Material& material = *item.material;
  Eigen::Vector4f placement;
  placement << material.texture_scale, material.texture_offset;
  program.set("texture_placement", placement);
  program.set("alpha_threshold", item.alpha_threshold);
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

#include "render/parts/material_setup.h"

#include <algorithm>

#include "render/gl/texture_units.h"
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

}  // namespace synthetic_dataset::render

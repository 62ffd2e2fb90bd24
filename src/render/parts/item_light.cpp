#include "render/parts/item_light.h"

namespace synthetic_dataset::render {

bool hasGlowOfItsOwn(const world::Material& material) {
  return material.emissive_map && material.emissive_map != material.texture;
}

ClassicLight classicLight(const world::Material& material) {
  ClassicLight light;
  if (!material.lit) {
    light.emissive = material.diffuse.head<3>();
    return light;
  }
  light.ambient = material.ambient;
  (hasGlowOfItsOwn(material) ? light.glow : light.emissive) += material.emissive;
  light.diffuse = material.diffuse.head<3>();
  if (material.shininess > 0.0F && !material.specular.isZero()) {
    light.specular = material.specular;
    light.shininess = material.shininess;
  }
  return light;
}

}  // namespace synthetic_dataset::render

#pragma once

#include "render/gl/shader_program.h"

namespace synthetic_dataset::render {

/// Where the shaders' samplers find their textures.
enum TextureUnit : GLuint {
  kDiffuseUnit,
  kShadowUnit,
  kNormalUnit,
  kRoughnessUnit,
  kMetalnessUnit,
  kEmissiveUnit,
  kShadowSideUnit,
};

/// Tells a program of them; samplers that it lacks make no difference.
inline void setTextureUnits(const ShaderProgram& program) {
  program.set("diffuse_map", static_cast<int>(kDiffuseUnit));
  program.set("shadow_maps", static_cast<int>(kShadowUnit));
  program.set("shadow_sides", static_cast<int>(kShadowSideUnit));
  program.set("normal_map", static_cast<int>(kNormalUnit));
  program.set("roughness_map", static_cast<int>(kRoughnessUnit));
  program.set("metalness_map", static_cast<int>(kMetalnessUnit));
  program.set("emissive_map", static_cast<int>(kEmissiveUnit));
}

}  // namespace synthetic_dataset::render

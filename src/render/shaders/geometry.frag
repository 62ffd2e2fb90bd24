#version 450 core
// The surface at each pixel's centre, to be lit afterwards: so each pixel is lit once, however
// many small triangles share it. Planes that the bound buffer lacks are left out.
#include "surface.glsl"
#include "material.glsl"
#include "near.glsl"

uniform uint item;

// The item and the bits of its depth share a plane: the number of planes costs more than their content.
layout(location = 0) out uvec2 item_depth;
layout(location = 1) out vec4 base_roughness;
layout(location = 2) out vec4 normal_metalness;
layout(location = 3) out vec4 face;
layout(location = 4) out vec4 glow;

void main() {
  float opacity;
  Surface surface = surfaceHere(opacity);
  discardTooNear();
  item_depth = uvec2(item, floatBitsToUint(surface.position_C.z));
  base_roughness = vec4(surface.base, surface.roughness);
  normal_metalness = vec4(surface.normal, surface.metalness);
  face = vec4(surface.face, 0.0);
  glow = vec4(glowHere(), 0.0);
}

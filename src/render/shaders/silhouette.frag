#version 450 core
// Whether a pixel's centre is on a surface.

uniform float alpha_threshold;
uniform sampler2D diffuse_map;

in vec3 position_C;
in vec3 normal_C;
in vec2 coordinates;
#include "near.glsl"

layout(location = 0) out float covered;

void main() {
#ifdef HOLES
  if (texture(diffuse_map, coordinates).a < alpha_threshold) discard;
#endif
  discardTooNear();
  covered = 1.0;
}

#version 450 core
// Transparent surfaces, lit while they are drawn.
#include "surface.glsl"
#include "material.glsl"
#include "near.glsl"
#include "lighting.glsl"

uniform vec3 emissive;
uniform float reflectance;

layout(location = 0) out vec4 colour;

void main() {
  float opacity;
  Surface surface = surfaceHere(opacity);
  discardTooNear();
  surface.reflectance = reflectance;
  surface.glow = emissive * glowHere();
#ifdef UNLIT
  colour = vec4(seen(surface, false), opacity);
#else
  colour = vec4(seen(surface, true), opacity);
#endif
}

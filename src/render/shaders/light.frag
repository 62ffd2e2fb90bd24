#version 450 core
// Lights what geometry.frag has drawn.
#include "surface.glsl"
#include "lighting.glsl"

uniform vec4 intrinsics;  // fx, fy, cx, cy [px]
uniform vec3 background;  // exposed
uniform usampler2D parts;
uniform sampler2D depths;
uniform sampler2D base_roughness;
uniform sampler2D normal_metalness;
#ifdef NORMAL_MAP
uniform sampler2D faces;
#endif
#ifdef EMISSIVE_MAP
uniform sampler2D glows;
#endif

// Of each part: emissive colour and reflectance, which is below 0 for one that light leaves as it
// is. In rows of PARTS_IN_ROW.
uniform sampler2D materials;

layout(location = 0) out vec4 colour;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint part = texelFetch(parts, pixel, 0).r;
  int index = max(int(part) - 1, 0);
  vec4 material = texelFetch(materials, ivec2(index % PARTS_IN_ROW, index / PARTS_IN_ROW), 0);
  vec4 base = texelFetch(base_roughness, pixel, 0);
  vec4 normal = texelFetch(normal_metalness, pixel, 0);
  float depth = texelFetch(depths, pixel, 0).r;

  Surface surface;
  surface.position_C = vec3((vec2(pixel) - intrinsics.zw) / intrinsics.xy, 1.0) * depth;
  surface.normal = normalize(normal.xyz);
  surface.face = surface.normal;
#ifdef NORMAL_MAP
  surface.face = normalize(texelFetch(faces, pixel, 0).xyz);
#endif
  surface.base = base.rgb;
  surface.roughness = base.a;
  surface.metalness = normal.a;
  surface.reflectance = material.a;
  surface.glow = material.rgb;
#ifdef EMISSIVE_MAP
  surface.glow *= texelFetch(glows, pixel, 0).rgb;
#endif
  vec3 light = seen(surface, material.a >= 0.0);
  colour = vec4(part == 0u ? background : light, 1.0);
}

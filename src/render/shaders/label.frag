#version 450 core
// What each pixel's centre sees: an identifier, and the depth along the optical axis [m].

uniform uint identifier;
uniform float alpha_threshold;
uniform sampler2D diffuse_map;

in vec3 position_C;
in vec3 normal_C;
in vec2 coordinates;

layout(location = 0) out uint id;
layout(location = 1) out float depth;

void main() {
#ifdef HOLES
  if (texture(diffuse_map, coordinates).a < alpha_threshold) discard;
#endif
  id = identifier;
  depth = position_C.z;
}

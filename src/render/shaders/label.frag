#version 450 core
// The surface at each pixel's centre: an identifier, the depth along the optical axis [m], the link and
// the surface's normal. The compiler leaves out what the bound target has no plane for.

uniform uint identifier;
uniform uint link;
uniform float alpha_threshold;
uniform sampler2D diffuse_map;

in vec3 position_C;
in vec3 normal_C;
in vec2 coordinates;
#include "near.glsl"

layout(location = 0) out uint id;
layout(location = 1) out float depth;
layout(location = 2) out uint seen_link;
layout(location = 3) out vec4 normal;

// Turned towards the camera. Vertex normals may point into the body or, near the silhouette of a
// round one, slightly away from the camera: the triangle tells which side is seen.
vec3 seenNormal() {
  vec3 to_camera = -normalize(position_C);
  vec3 flat_normal = cross(dFdx(position_C), dFdy(position_C));
  if (dot(flat_normal, to_camera) < 0.0) flat_normal = -flat_normal;
  vec3 n = normalize(normal_C);
  if (dot(n, flat_normal) < 0.0) n = -n;
  float away = min(dot(n, to_camera), 0.0);
  return normalize(n - away * to_camera);
}

void main() {
  // Before pixels are discarded: derivatives need their neighbours.
  vec3 n = seenNormal();
#ifdef HOLES
  if (texture(diffuse_map, coordinates).a < alpha_threshold) discard;
#endif
  discardTooNear();
  id = identifier;
  depth = position_C.z;
  seen_link = link;
  normal = vec4(n, 0.0);
}

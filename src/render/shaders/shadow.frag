#version 450 core
// Depth alone; holes of a texture let the light through.

uniform float alpha_threshold;
uniform sampler2D diffuse_map;

in vec2 coordinates;

void main() {
#ifdef HOLES
  if (texture(diffuse_map, coordinates).a < alpha_threshold) discard;
#endif
}

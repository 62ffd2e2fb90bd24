#version 450 core
// Depth alone; holes of a texture let the light through.

uniform int textured;
uniform sampler2D diffuse_map;

in vec2 coordinates;

void main() {
  if (textured != 0 && texture(diffuse_map, coordinates).a < 0.5) discard;
}

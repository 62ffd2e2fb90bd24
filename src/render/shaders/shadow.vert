#version 450 core

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 texture_coordinates;

uniform mat4 shadow_from_mesh;
uniform vec4 texture_placement;  // scale, offset

out vec2 coordinates;

void main() {
  coordinates = texture_coordinates * texture_placement.xy + texture_placement.zw;
  gl_Position = shadow_from_mesh * vec4(position, 1.0);
}

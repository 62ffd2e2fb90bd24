#version 450 core
// Every pass that the camera sees shares this stage, so that colour and labels meet at the same edge.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_coordinates;
layout(location = 3) in vec4 vertex_colour;  // linear

uniform mat4 camera_from_mesh;
uniform mat4 clip_from_camera;
uniform vec4 texture_placement;  // scale, offset

out vec3 position_C;
out vec3 normal_C;
out vec2 coordinates;
#ifdef TINTED
out vec4 tint;
#endif

invariant gl_Position;

void main() {
  vec4 p_C = camera_from_mesh * vec4(position, 1.0);
  position_C = p_C.xyz;
  normal_C = mat3(camera_from_mesh) * normal;
  coordinates = texture_coordinates * texture_placement.xy + texture_placement.zw;
#ifdef TINTED
  tint = vertex_colour;
#endif
  gl_Position = clip_from_camera * p_C;
}

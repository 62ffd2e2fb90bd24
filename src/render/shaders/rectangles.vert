#version 450 core
// Rectangles of a picture, one an instance, at the far plane (depth is reversed).

uniform vec4 rectangles[MAX_RECTANGLES];  // left, top, right, bottom in clip coordinates

void main() {
  vec4 rectangle = rectangles[gl_InstanceID];
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(rectangle.xy, rectangle.zw, corner), 0.0, 1.0);
}

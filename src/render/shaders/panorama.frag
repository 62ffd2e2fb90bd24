#version 450 core
// An equirectangular picture round the world, in the direction of each pixel.

const float kPi = 3.14159265;

uniform mat4 world_from_camera;
uniform vec4 intrinsics;  // fx, fy, cx, cy [px]
uniform sampler2D picture;
uniform float yaw;        // azimuth of the picture's middle, from x to y [rad]
uniform float gain;       // multiplies its light

layout(location = 0) out vec4 colour;

vec3 directionAt(vec2 pixel) {
  vec3 ray_C = vec3((pixel - intrinsics.zw) / intrinsics.xy, 1.0);
  return normalize(mat3(world_from_camera) * ray_C);
}

#include "shown.glsl"

void main() {
  // A pixel's centre, whole in OpenCV's convention, is half past in OpenGL's.
  vec2 pixel = gl_FragCoord.xy - 0.5;
  vec3 direction = directionAt(pixel);
  float azimuth = atan(direction.y, direction.x);
  float elevation = atan(direction.z, length(direction.xy));
  vec2 place = vec2(fract(0.5 - (azimuth - yaw) / (2.0 * kPi)), 0.5 - elevation / kPi);
  // A smaller copy of the picture where a pixel covers much of it. Its rows say how much; near the
  // poles its columns are closer together, but there they show the same.
  float across = distance(direction, directionAt(pixel + vec2(1.0, 0.0)));
  float down = distance(direction, directionAt(pixel + vec2(0.0, 1.0)));
  float rows = max(across, down) * float(textureSize(picture, 0).y) / kPi;
  vec3 light = textureLod(picture, place, log2(max(rows, 1.0))).rgb;
  colour = vec4(shown(min(gain * light, vec3(1.0))), 1.0);
}

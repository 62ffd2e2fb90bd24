#version 450 core
// A picture that fills the image, wherever the camera looks.

uniform sampler2D picture;
uniform float gain;  // multiplies its light

#ifdef THROUGH_LENS
// What is drawn is a part of what a lens sees, before it is bent: the picture is straight in the
// image, so it is bent the other way here. The formulas are those of CameraModel.
uniform vec4 intrinsics;       // fx, fy, cx, cy of what is drawn [px]
uniform mat4 lens_from_face;   // the frame of what is drawn in the lens's
uniform vec4 lens_intrinsics;  // fx, fy, cx, cy of the image [px]
uniform vec4 image_size;       // width, height [px]
uniform vec4 coefficients[2];  // as CameraInfo's D has them
uniform int is_fisheye;

vec2 bent(vec3 ray) {
  vec4 k = coefficients[0];
  if (is_fisheye != 0) {
    float across = length(ray.xy);
    float angle = atan(across, ray.z);
    float t = angle * angle;
    float far = angle * (1.0 + t * (k.x + t * (k.y + t * (k.z + t * k.w))));
    return ray.xy * (far / max(across, 1e-9));
  }
  vec4 more = coefficients[1];
  vec2 x = ray.xy / max(ray.z, 1e-6);
  float s = dot(x, x);
  float above = 1.0 + s * (k.x + s * (k.y + s * more.x));
  float below = 1.0 + s * (more.y + s * (more.z + s * more.w));
  return x * (above / max(below, 1e-6)) + 2.0 * dot(k.wz, x) * x + s * k.wz;
}

vec3 light() {
  vec2 pixel = gl_FragCoord.xy - 0.5;
  vec3 ray = mat3(lens_from_face) * vec3((pixel - intrinsics.zw) / intrinsics.xy, 1.0);
  vec2 place = lens_intrinsics.xy * bent(normalize(ray)) + lens_intrinsics.zw;
  return textureLod(picture, (place + 0.5) / image_size.xy, 0.0).rgb;
}
#else
vec3 light() { return texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb; }
#endif

layout(location = 0) out vec4 colour;

void main() { colour = vec4(min(gain * light(), vec3(1.0)), 1.0); }

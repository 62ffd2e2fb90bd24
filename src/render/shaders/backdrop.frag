#version 450 core
// A picture that fills the image, wherever the camera looks.

uniform sampler2D picture;
uniform float gain;  // multiplies its light

#ifdef THROUGH_LENS
// A part of a lens's view is drawn, before distortion: the picture should be straight in the image,
// so the inverse distortion is applied here. The formulas are those of CameraModel.
uniform vec4 intrinsics;       // fx, fy, cx, cy of the drawn part [px]
uniform mat4 lens_from_face;   // from the drawn part's frame to the lens's
uniform vec4 lens_intrinsics;  // fx, fy, cx, cy of the image [px]
uniform vec4 image_size;       // width, height [px]
uniform vec4 coefficients[4];  // in the order of Distortion
uniform int lens;              // its DistortionModel

const int kEquidistant = 3;
const int kOmnidirectional = 4;
const int kDoubleSphere = 5;

// OpenCV's polynomials: k1, k2, p1, p2; k3 to k6; s1 to s4, tau_x, tau_y.
vec2 bent(vec2 x, vec4 k, vec4 more, vec4 prism, vec2 tilt) {
  float s = dot(x, x);
  float above = 1.0 + s * (k.x + s * (k.y + s * more.x));
  float below = 1.0 + s * (more.y + s * (more.z + s * more.w));
  vec2 place = x * (above / max(below, 1e-6)) + 2.0 * dot(k.wz, x) * x + s * k.wz;
  place += s * prism.xz + s * s * prism.yw;
  if (tilt == vec2(0.0)) return place;
  vec2 c = cos(tilt);
  vec2 n = sin(tilt);
  vec3 turned = vec3(c.y * place.x + n.y * (n.x * place.y - c.x), c.x * place.y + n.x,
                     n.y * place.x + c.y * (c.x - n.x * place.y));
  vec3 axis = vec3(-n.y * c.x, n.x, c.y * c.x);
  vec2 seen = axis.z * turned.xy - axis.xy * turned.z;
  return seen / max(turned.z, 1e-6);
}

vec2 placeOf(vec3 ray) {  // of length 1
  vec4 c = coefficients[0];
  float across = length(ray.xy);
  if (lens == kEquidistant) {
    float angle = atan(across, ray.z);
    float t = angle * angle;
    float far = angle * (1.0 + t * (c.x + t * (c.y + t * (c.z + t * c.w))));
    return ray.xy * (far / max(across, 1e-9));
  }
  if (lens == kOmnidirectional) {
    vec4 rest = coefficients[1];
    vec2 place = bent(ray.xy / max(ray.z + c.x, 1e-6), vec4(c.yzw, rest.x), vec4(0.0), vec4(0.0),
                      vec2(0.0));
    return vec2(place.x + rest.y * place.y, place.y);
  }
  if (lens == kDoubleSphere) {
    float z = c.x + ray.z;
    float below = c.y * sqrt(across * across + z * z) + (1.0 - c.y) * z;
    return ray.xy / max(below, 1e-6);
  }
  return bent(ray.xy / max(ray.z, 1e-6), c, coefficients[1], coefficients[2], coefficients[3].xy);
}

vec3 light() {
  vec2 pixel = gl_FragCoord.xy - 0.5;
  vec3 ray = mat3(lens_from_face) * vec3((pixel - intrinsics.zw) / intrinsics.xy, 1.0);
  vec2 place = lens_intrinsics.xy * placeOf(normalize(ray)) + lens_intrinsics.zw;
  return textureLod(picture, (place + 0.5) / image_size.xy, 0.0).rgb;
}
#else
vec3 light() { return texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb; }
#endif

layout(location = 0) out vec4 colour;

#include "shown.glsl"

void main() { colour = vec4(shown(min(gain * light(), vec3(1.0))), 1.0); }

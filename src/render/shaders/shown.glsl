// What is laid under what one can see through, from exposed light. With ENCODED that is found in
// encoded numbers, which are exposed later (pixels/encoded_light.h).
#ifdef ENCODED
uniform float exposure_later;

vec3 shown(vec3 exposed) {
  vec3 linear = exposed / exposure_later;
  vec3 bright = 1.055 * pow(max(linear, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055;
  return mix(bright, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}
#else
vec3 shown(vec3 exposed) { return exposed; }
#endif

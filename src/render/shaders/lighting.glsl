// Lighting of transparent surfaces; classic_shading.h (with CLASSIC) and surface_shading.h light all
// others in the same way. The latter: Lambert diffuse, GGX specular (Walter et al. 2007, with
// Schlick's Fresnel and the height-correlated visibility of Heitz 2014 in Hammon's approximation),
// hemispheric ambient light, all of it linear, in the camera's optical frame.

// LIGHT(i, TYPE, FIRST_MAP) for each light is EACH_LIGHT, set when this is compiled: llvmpipe
// runs every branch of a shader for every pixel, and each loop once more than necessary, so a
// feature that a light lacks is free only if its code is left out. The types are those of
// world::LightType.
// SHADOW_RAISE and GRAZING_SHADOW_RAISE [texel] are set with it, and SHADOW_MAPS, after which the
// sides of point lights come, and SHADOW_COUNT of both.
#define DIRECTIONAL 0
#define POINT 1
#define SPOT 2
const int kLinearFog = 0;
const int kExponentialFog = 1;
const float kPi = 3.14159265;

struct Light {
  vec3 position_C;
  vec3 direction_C;  // in which it shines
  vec3 intensity;
  vec3 specular;     // of highlights in Gazebo Classic
  vec3 attenuation;  // constant, linear, quadratic
  float range;
  vec3 cone;         // cosine of the inner angle, cosine of the outer angle, falloff
};

uniform Light lights[LIGHT_COUNT];
uniform mat4 shadow_from_camera[SHADOW_COUNT];
uniform float shadow_texel[SHADOW_COUNT];  // size of a texel [m], for spot and point lights at 1 m
uniform sampler2DArrayShadow shadow_maps;
uniform sampler2DArrayShadow shadow_sides;

uniform float exposure;  // multiplies all light
uniform vec3 ambient;
uniform vec3 up_C;

#ifdef FOG
uniform int fog_type;
uniform vec3 fog_colour;
uniform vec3 fog_extent;  // start [m], end [m], density [1/m]
#endif

#ifdef SHADOWS
// The share of the light that passes: the mean over a square of 3 x 3 texels around the point, found
// from 4 x 4 texels, of which those at the rim count by their overlap.
float passing(sampler2DArrayShadow maps, vec2 place, int layer, float depth) {
  vec2 size = vec2(textureSize(maps, 0).xy);
  vec2 texel = place * size - 0.5;
  vec2 first = floor(texel);
  vec2 share = texel - first;
  // A gather takes the four texels around a corner: lower left is w, right of it z, above that y, x.
  vec2 corner = first / size;
  vec2 step = 2.0 / size;
  vec4 a = textureGather(maps, vec3(corner, layer), depth);
  vec4 b = textureGather(maps, vec3(corner + vec2(step.x, 0.0), layer), depth);
  vec4 c = textureGather(maps, vec3(corner + vec2(0.0, step.y), layer), depth);
  vec4 d = textureGather(maps, vec3(corner + step, layer), depth);
  vec2 rim = 1.0 - share;
  float low = rim.x * a.w + a.z + b.w + share.x * b.z;
  float low_middle = rim.x * a.x + a.y + b.x + share.x * b.y;
  float high_middle = rim.x * c.w + c.z + d.w + share.x * d.z;
  float high = rim.x * c.x + c.y + d.x + share.x * d.y;
  return (rim.y * low + low_middle + high_middle + share.y * high) / 9.0;
}

// The face of a point light's cube in whose direction a point lies.
int sideAt(int first, vec3 position_C) {
  int side = first;
  float farthest = 0.0;
  for (int i = first; i < first + 6; ++i) {
    float ahead = (shadow_from_camera[i] * vec4(position_C, 1.0)).w;
    side = ahead > farthest ? i : side;
    farthest = max(ahead, farthest);
  }
  return side;
}

float shadow(Light light, int type, int first_map, vec3 position_C, vec3 normal, float n_dot_l) {
  int map = max(first_map, 0);
  if (type == POINT) map = sideAt(map, position_C);
  // Compares the surface raised by about a texel, more at grazing light.
  float texel = shadow_texel[map];
  if (type != DIRECTIONAL) texel *= distance(position_C, light.position_C);
  float slope = sqrt(max(1.0 - n_dot_l * n_dot_l, 0.0));
  vec3 raised = position_C + normal * texel * (SHADOW_RAISE + GRAZING_SHADOW_RAISE * slope);
  vec4 p = shadow_from_camera[map] * vec4(raised, 1.0);
  bool outside = p.w <= 0.0;
  p.xyz /= p.w;
  vec2 place = p.xy * 0.5 + 0.5;
  // Points outside the map are not in shadow. (A border colour has the same effect, but costs
  // llvmpipe a third more time.)
  outside = outside || any(greaterThan(abs(place - 0.5), vec2(0.5)));
  if (type == POINT) {
    // With simple light, point lights have no shadows.
    outside = outside || shadow_texel[map] == 0.0;
    return outside ? 1.0 : passing(shadow_sides, place, map - SHADOW_MAPS, min(p.z, 1.0));
  }
  return outside ? 1.0 : passing(shadow_maps, place, map, min(p.z, 1.0));
}
#endif

// The share of the light's intensity that arrives at the point, and its direction.
float arriving(Light light, int type, vec3 position_C, out vec3 to_light) {
  if (type == DIRECTIONAL) {
    to_light = -light.direction_C;
    return 1.0;
  }
  vec3 way = light.position_C - position_C;
  float d = length(way);
  to_light = way / max(d, 1e-6);
  float falling = 1.0 / max(dot(light.attenuation, vec3(1.0, d, d * d)), 1e-6);
  if (type == SPOT) {
    float cosine = dot(-to_light, light.direction_C);
    float edge = max(light.cone.x - light.cone.y, 1e-4);
    float inside = clamp((cosine - light.cone.y) / edge, 0.0, 1.0);
    falling *= pow(inside, max(light.cone.z, 1e-3));
  }
  return d > light.range ? 0.0 : falling;
}

#ifdef FOG
// The share of fog in the colour seen at a distance [m] from the camera. (OGRE takes the depth
// along the axis instead, so that its fog changes where a camera turns.)
float fogginess(float far) {
  float clear = 1.0;
  if (fog_type == kLinearFog) {
    clear = (fog_extent.y - far) / max(fog_extent.y - fog_extent.x, 1e-6);
  } else {
    float thickness = fog_extent.z * far;
    clear = exp(fog_type == kExponentialFog ? -thickness : -thickness * thickness);
  }
  return 1.0 - clamp(clear, 0.0, 1.0);
}
#endif

#ifdef CLASSIC
// Lights each pixel as OGRE 1 does in Gazebo Classic (ClassicShading): all numbers are sRGB-encoded.
uniform vec3 around;           // ambient and emissive
uniform vec3 diffuse_colour;
uniform vec3 specular_colour;
uniform float shininess;       // 0: there is no highlight
uniform float brightest;

// Adds the light of one source that a surface reflects.
void add(Light light, int type, int first_map, Surface surface, vec3 to_eye, inout vec3 matte,
         inout vec3 shine) {
  vec3 to_light;
  float share = arriving(light, type, surface.position_C, to_light);
  float n_dot_l = dot(surface.normal, to_light);
#ifdef SHADOWS
  if (first_map >= 0) {
    // For the lit side of the surface.
    float face_dot_l = dot(surface.face, to_light);
    vec3 side = face_dot_l < 0.0 ? -surface.face : surface.face;
    share *= shadow(light, type, first_map, surface.position_C, side, abs(face_dot_l));
  }
#endif
  if (n_dot_l <= 0.0) share = 0.0;
  matte += light.intensity * (n_dot_l * share);
  float n_dot_h = clamp(dot(surface.normal, normalize(to_light + to_eye)), 0.0, 1.0);
  if (shininess > 0.0) shine += light.specular * (pow(max(n_dot_h, 1e-6), shininess) * share);
}

// The colour of a surface for the camera, before exposure.
vec3 seen(Surface surface, bool is_lit) {
  vec3 matte = around;
  vec3 shine = vec3(0.0);
  if (is_lit) {
    vec3 to_eye = normalize(-surface.position_C);
    vec3 sum = vec3(0.0);
#define LIGHT(i, type, first_map) add(lights[i], type, first_map, surface, to_eye, sum, shine);
    EACH_LIGHT
#undef LIGHT
    matte += diffuse_colour * sum;
  }
  vec3 light = min(matte * surface.base + specular_colour * shine + surface.glow, vec3(brightest));
#ifdef FOG
  light = mix(light, fog_colour, fogginess(length(surface.position_C)));
#endif
  return light;
}
#else
vec3 fresnel(vec3 f0, float cosine) {
  float x = 1.0 - cosine;
  return f0 + (1.0 - f0) * (x * x) * (x * x) * x;
}

vec3 specular(vec3 f0, float alpha, float n_dot_l, float n_dot_v, float n_dot_h, float v_dot_h) {
  float a2 = alpha * alpha;
  float bell = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
  float distribution = a2 / (kPi * bell * bell);
  float visibility = 0.5 / mix(2.0 * n_dot_l * n_dot_v, n_dot_l + n_dot_v, alpha);
  return distribution * visibility * fresnel(f0, v_dot_h);
}

// Linear up to 0.8, then bending towards 1 so that bright surfaces keep their contrast.
vec3 shoulder(vec3 linear) {
  vec3 soft = 0.8 + 0.2 * (1.0 - exp(-(linear - 0.8) / 0.2));
  return mix(linear, soft, greaterThan(linear, vec3(0.8)));
}

// The light of one source that a surface reflects to the camera.
vec3 sent(Light light, int type, int first_map, Surface surface, vec3 f0, vec3 matte, float alpha,
          vec3 to_eye, float n_dot_v) {
  vec3 to_light;
  vec3 coming = light.intensity * arriving(light, type, surface.position_C, to_light);
  float n_dot_l = dot(surface.normal, to_light);
  float face_dot_l = dot(surface.face, to_light);
#ifdef SHADOWS
  if (first_map >= 0) {
    coming *= shadow(light, type, first_map, surface.position_C, surface.face, face_dot_l);
  }
#endif
  vec3 halfway = normalize(to_light + to_eye);
  float n_dot_h = max(dot(surface.normal, halfway), 0.0);
  float v_dot_h = max(dot(to_eye, halfway), 0.0);
  // Lights are given so that a white matte surface facing one of intensity 1 is just white: pi is
  // left out of the diffuse term, and put back into the specular one.
  vec3 shine = kPi * specular(f0, alpha, n_dot_l, n_dot_v, n_dot_h, v_dot_h);
  bool dark = n_dot_l <= 0.0 || face_dot_l <= 0.0;
  return dark ? vec3(0.0) : coming * n_dot_l * (matte + shine);
}

// The light that a surface sends to the camera.
vec3 lit(Surface surface) {
  vec3 to_eye = normalize(-surface.position_C);
  vec3 f0 = mix(vec3(surface.reflectance), surface.base, surface.metalness);
  vec3 matte = surface.base * (1.0 - surface.metalness);
  float alpha = max(surface.roughness * surface.roughness, 0.01);
  float n_dot_v = max(dot(surface.normal, to_eye), 1e-3);

  float sky = 0.5 + 0.5 * dot(surface.normal, up_C);
  vec3 around = ambient * mix(0.55, 1.0, sky);
  vec3 reflected = fresnel(f0, n_dot_v) * mix(1.0, 0.4, surface.roughness);
  vec3 sum = around * (matte + reflected) + surface.glow;

#define LIGHT(i, type, first_map) \
  sum += sent(lights[i], type, first_map, surface, f0, matte, alpha, to_eye, n_dot_v);
  EACH_LIGHT
#undef LIGHT
  return sum;
}

// The colour of a surface in the picture, limited to what a picture can show.
vec3 seen(Surface surface, bool is_lit) {
  vec3 light = is_lit ? shoulder(exposure * lit(surface)) : exposure * surface.base;
#ifdef FOG
  light = mix(light, exposure * fog_colour, fogginess(length(surface.position_C)));
#endif
  return min(light, vec3(1.0));
}
#endif

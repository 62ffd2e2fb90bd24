#version 450 core
// Lit colour: Lambert diffuse, GGX specular (Walter et al. 2007, with Schlick's Fresnel and the
// height-correlated visibility of Heitz 2014 in Hammon's approximation), hemispheric ambient light.
// All lighting is linear and happens in the camera's optical frame.

// LIGHT(i, TYPE, SHADOW_LAYER) for each light is EACH_LIGHT, set when this is compiled: llvmpipe
// runs every branch of a shader for every pixel, and a loop once more than it says, so what a light
// has not costs nothing only if it is not there. The types are those of world::LightType; 1 is a point.
#define DIRECTIONAL 0
#define SPOT 2
const int kLinearFog = 0;
const int kExponentialFog = 1;
const float kPi = 3.14159265;

struct Light {
  vec3 position_C;
  vec3 direction_C;  // where it shines
  vec3 intensity;
  vec3 attenuation;  // constant, linear, quadratic
  float range;
  vec3 cone;         // cosine of the inner angle, cosine of the outer angle, falloff
};

uniform Light lights[MAX_LIGHTS];
uniform mat4 shadow_from_camera[MAX_SHADOWS];
uniform float shadow_texel[MAX_SHADOWS];  // size of a texel [m], for spot lights at 1 m
uniform sampler2DArrayShadow shadow_maps;

uniform float exposure;  // multiplies all light
uniform vec3 ambient;
uniform vec3 up_C;

uniform vec4 diffuse;
uniform vec3 emissive;
uniform float reflectance;
uniform float roughness;
uniform float metalness;
uniform float alpha_threshold;
uniform sampler2D diffuse_map;
uniform sampler2D normal_map;
uniform sampler2D roughness_map;
uniform sampler2D metalness_map;
uniform sampler2D emissive_map;

#ifdef FOG
uniform int fog_type;
uniform vec3 fog_colour;
uniform vec3 fog_extent;  // start [m], end [m], density [1/m]
#endif

in vec3 position_C;
in vec3 normal_C;
in vec2 coordinates;
#ifdef TINTED
in vec4 tint;
#endif

layout(location = 0) out vec4 colour;

#ifdef SHADOWS
// How much of the light passes: the mean over a square of 3 x 3 texels round the place, whose rim
// counts by its share, found from 4 x 4 texels.
float passing(vec2 place, int layer, float depth) {
  vec2 size = vec2(textureSize(shadow_maps, 0).xy);
  vec2 texel = place * size - 0.5;
  vec2 first = floor(texel);
  vec2 share = texel - first;
  // A gather takes the four texels round a corner: lower left is w, right of it z, above that y, x.
  vec2 corner = first / size;
  vec2 step = 2.0 / size;
  vec4 a = textureGather(shadow_maps, vec3(corner, layer), depth);
  vec4 b = textureGather(shadow_maps, vec3(corner + vec2(step.x, 0.0), layer), depth);
  vec4 c = textureGather(shadow_maps, vec3(corner + vec2(0.0, step.y), layer), depth);
  vec4 d = textureGather(shadow_maps, vec3(corner + step, layer), depth);
  vec2 rim = 1.0 - share;
  float low = rim.x * a.w + a.z + b.w + share.x * b.z;
  float low_middle = rim.x * a.x + a.y + b.x + share.x * b.y;
  float high_middle = rim.x * c.w + c.z + d.w + share.x * d.z;
  float high = rim.x * c.x + c.y + d.x + share.x * d.y;
  return (rim.y * low + low_middle + high_middle + share.y * high) / 9.0;
}

float shadow(Light light, int type, int layer, vec3 normal, float n_dot_l) {
  // A surface is compared a little above itself, by about a texel, more at grazing light.
  float texel = shadow_texel[max(layer, 0)];
  if (type == SPOT) texel *= distance(position_C, light.position_C);
  float slope = sqrt(max(1.0 - n_dot_l * n_dot_l, 0.0));
  vec3 raised = position_C + normal * texel * (0.6 + 2.2 * slope);
  vec4 p = shadow_from_camera[max(layer, 0)] * vec4(raised, 1.0);
  bool outside = p.w <= 0.0;
  p.xyz /= p.w;
  vec2 place = p.xy * 0.5 + 0.5;
  // Nothing is in the shadow of what lies outside of the map. (A border colour says the same, but
  // costs llvmpipe a third more time.)
  outside = outside || any(greaterThan(abs(place - 0.5), vec2(0.5)));
  return outside ? 1.0 : passing(place, layer, min(p.z, 1.0));
}
#endif

// What of the light arrives at the point, and from where.
vec3 incoming(Light light, int type, out vec3 to_light) {
  if (type == DIRECTIONAL) {
    to_light = -light.direction_C;
    return light.intensity;
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
  return d > light.range ? vec3(0.0) : light.intensity * falling;
}

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

// Linear up to 0.8, then bending towards 1 so that bright surfaces keep their drawing.
vec3 shoulder(vec3 linear) {
  vec3 soft = 0.8 + 0.2 * (1.0 - exp(-(linear - 0.8) / 0.2));
  return mix(linear, soft, greaterThan(linear, vec3(0.8)));
}

// The normal as the map bends it. The map's x axis is where the texture's u grows and its y axis
// where v falls (v counts from the first row down): both from the derivatives of position and
// coordinates, so that meshes need no tangents (Schueler 2013, "Normal Mapping Without Precomputed
// Tangents").
vec3 bent(vec3 normal) {
  vec3 along_x = dFdx(position_C);
  vec3 along_y = dFdy(position_C);
  vec2 texture_x = dFdx(coordinates);
  vec2 texture_y = dFdy(coordinates);
  vec3 across_y = cross(along_y, normal);
  vec3 across_x = cross(normal, along_x);
  // Negative where the picture's axes turn left about the normal, which would turn both tangents.
  float turn = sign(dot(along_x, across_y));
  vec3 u_axis = turn * (across_y * texture_x.x + across_x * texture_y.x);
  vec3 v_axis = turn * (across_y * texture_x.y + across_x * texture_y.y);
  float longest = max(dot(u_axis, u_axis), dot(v_axis, v_axis));
  if (longest <= 0.0) return normal;  // no texture coordinates
  vec3 bend = texture(normal_map, coordinates).xyz * 2.0 - 1.0;
  return normalize((bend.x * u_axis - bend.y * v_axis) * inversesqrt(longest) + bend.z * normal);
}

// What of one light a surface sends to the eye.
vec3 sent(Light light, int type, int layer, vec3 f0, vec3 matte, float alpha, vec3 normal,
          vec3 surface, vec3 to_eye, float n_dot_v) {
  vec3 to_light;
  vec3 arriving = incoming(light, type, to_light);
  float n_dot_l = dot(normal, to_light);
  float surface_dot_l = dot(surface, to_light);
#ifdef SHADOWS
  if (layer >= 0) arriving *= shadow(light, type, layer, surface, surface_dot_l);
#endif
  vec3 halfway = normalize(to_light + to_eye);
  float n_dot_h = max(dot(normal, halfway), 0.0);
  float v_dot_h = max(dot(to_eye, halfway), 0.0);
  // Lights are given so that a white matte surface facing one of intensity 1 is just white: pi is
  // left out of the diffuse term, and put back into the specular one.
  vec3 shine = kPi * specular(f0, alpha, n_dot_l, n_dot_v, n_dot_h, v_dot_h);
  bool dark = n_dot_l <= 0.0 || surface_dot_l <= 0.0;
  return dark ? vec3(0.0) : arriving * n_dot_l * (matte + shine);
}

// The light that a surface of this colour sends to the eye.
vec3 lit(vec3 base) {
  vec3 to_eye = normalize(-position_C);
  vec3 surface = normalize(normal_C);
  vec3 normal = surface;
#ifdef NORMAL_MAP
  normal = bent(surface);
#endif
  if (!gl_FrontFacing) {
    surface = -surface;
    normal = -normal;
  }

  float rough = roughness;
#ifdef ROUGHNESS_MAP
  rough *= texture(roughness_map, coordinates).g;
#endif
  float metal = metalness;
#ifdef METALNESS_MAP
  metal *= texture(metalness_map, coordinates).b;
#endif
  vec3 glow = emissive;
#ifdef EMISSIVE_MAP
  glow *= texture(emissive_map, coordinates).rgb;
#endif

  vec3 f0 = mix(vec3(reflectance), base, metal);
  vec3 matte = base * (1.0 - metal);
  float alpha = max(rough * rough, 0.01);
  float n_dot_v = max(dot(normal, to_eye), 1e-3);

  float sky = 0.5 + 0.5 * dot(normal, up_C);
  vec3 around = ambient * mix(0.55, 1.0, sky);
  vec3 sum = around * (matte + fresnel(f0, n_dot_v) * mix(1.0, 0.4, rough)) + glow;

#define LIGHT(i, type, layer) \
  sum += sent(lights[i], type, layer, f0, matte, alpha, normal, surface, to_eye, n_dot_v);
  EACH_LIGHT
#undef LIGHT
  return sum;
}

#ifdef FOG
// The share of the fog in what is seen at a distance [m] from the camera. (OGRE takes the depth
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

void main() {
  vec4 base = diffuse;
#ifdef TINTED
  base *= tint;
#endif
#ifdef TEXTURED
  vec4 texel = texture(diffuse_map, coordinates);
#ifdef HOLES
  if (texel.a < alpha_threshold) discard;  // as the other passes have it
#endif
  base.rgb *= texel.rgb;
#ifdef GLASS
  base.a *= texel.a;
#endif
#endif

#ifdef UNLIT
  vec3 seen = exposure * base.rgb;
#else
  vec3 seen = shoulder(exposure * lit(base.rgb));
#endif
#ifdef FOG
  seen = mix(seen, exposure * fog_colour, fogginess(length(position_C)));
#endif
  // As bright as a picture can be, before samples are averaged.
  colour = vec4(min(seen, vec3(1.0)), base.a);
}

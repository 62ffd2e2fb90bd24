#version 450 core
// Lit colour: Lambert diffuse, GGX specular (Walter et al. 2007, with Schlick's Fresnel and the
// height-correlated visibility of Heitz 2014 in Hammon's approximation), hemispheric ambient light.
// All lighting is linear and happens in the camera's optical frame.

const int kDirectional = 0;
const int kSpot = 2;
const float kPi = 3.14159265;

struct Light {
  int type;
  vec3 position_C;
  vec3 direction_C;  // where it shines
  vec3 intensity;
  vec3 attenuation;  // constant, linear, quadratic
  float range;
  vec3 cone;         // cosine of the inner angle, cosine of the outer angle, falloff
  int shadow_layer;  // -1: casts none
};

uniform Light lights[MAX_LIGHTS];
uniform int light_count;
uniform mat4 shadow_from_camera[MAX_SHADOWS];
uniform float shadow_texel[MAX_SHADOWS];  // size of a texel [m], for spot lights at 1 m
uniform sampler2DArrayShadow shadow_maps;

uniform vec3 ambient;
uniform vec3 up_C;

uniform vec4 diffuse;
uniform vec3 emissive;
uniform float reflectance;
uniform float roughness;
uniform float metalness;
uniform int textured;
uniform sampler2D diffuse_map;

in vec3 position_C;
in vec3 normal_C;
in vec2 coordinates;

layout(location = 0) out vec4 colour;

float shadow(Light light, vec3 normal, float n_dot_l) {
  if (light.shadow_layer < 0) return 1.0;
  // A surface is compared a little above itself, by about a texel, more at grazing light.
  float texel = shadow_texel[light.shadow_layer];
  if (light.type == kSpot) texel *= distance(position_C, light.position_C);
  float slope = sqrt(1.0 - n_dot_l * n_dot_l);
  vec3 raised = position_C + normal * texel * (0.6 + 2.2 * slope);
  vec4 p = shadow_from_camera[light.shadow_layer] * vec4(raised, 1.0);
  if (p.w <= 0.0) return 1.0;
  p.xyz /= p.w;
  vec2 place = p.xy * 0.5 + 0.5;
  float depth = min(p.z, 1.0);
  vec2 step = 1.0 / vec2(textureSize(shadow_maps, 0).xy);
  float lit = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      vec2 tap = place + vec2(x, y) * step * 1.2;
      lit += texture(shadow_maps, vec4(tap, light.shadow_layer, depth));
    }
  }
  return lit / 9.0;
}

// What of the light arrives at the point, and from where.
vec3 incoming(Light light, out vec3 to_light) {
  if (light.type == kDirectional) {
    to_light = -light.direction_C;
    return light.intensity;
  }
  vec3 way = light.position_C - position_C;
  float d = length(way);
  to_light = way / max(d, 1e-6);
  if (d > light.range) return vec3(0.0);
  float falling = 1.0 / max(dot(light.attenuation, vec3(1.0, d, d * d)), 1e-6);
  if (light.type == kSpot) {
    float cosine = dot(-to_light, light.direction_C);
    float inside = clamp((cosine - light.cone.y) / max(light.cone.x - light.cone.y, 1e-4), 0.0, 1.0);
    falling *= pow(inside, max(light.cone.z, 1e-3));
  }
  return light.intensity * falling;
}

vec3 fresnel(vec3 f0, float cosine) { return f0 + (1.0 - f0) * pow(1.0 - cosine, 5.0); }

vec3 specular(vec3 f0, float alpha, float n_dot_l, float n_dot_v, float n_dot_h, float v_dot_h) {
  float a2 = alpha * alpha;
  float bell = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
  float distribution = a2 / (kPi * bell * bell);
  float visibility = 0.5 / mix(2.0 * n_dot_l * n_dot_v, n_dot_l + n_dot_v, alpha);
  return distribution * visibility * fresnel(f0, v_dot_h);
}

// Linear up to 0.8, then bending towards 1 so that bright surfaces keep their drawing.
vec3 shoulder(vec3 linear) {
  return mix(linear, 0.8 + 0.2 * (1.0 - exp(-(linear - 0.8) / 0.2)), greaterThan(linear, vec3(0.8)));
}

void main() {
  vec4 base = diffuse;
  if (textured != 0) {
    vec4 texel = texture(diffuse_map, coordinates);
    if (texel.a < 0.5) discard;  // a hole, as the label pass has it
    base.rgb *= texel.rgb;
  }

  vec3 to_eye = normalize(-position_C);
  vec3 normal = normalize(normal_C);
  if (!gl_FrontFacing) normal = -normal;

  vec3 f0 = mix(vec3(reflectance), base.rgb, metalness);
  vec3 matte = base.rgb * (1.0 - metalness);
  float alpha = max(roughness * roughness, 0.01);
  float n_dot_v = max(dot(normal, to_eye), 1e-3);

  float sky = 0.5 + 0.5 * dot(normal, up_C);
  vec3 around = ambient * mix(0.55, 1.0, sky);
  vec3 sum = around * (matte + fresnel(f0, n_dot_v) * mix(1.0, 0.4, roughness)) + emissive;

  for (int i = 0; i < light_count; ++i) {
    vec3 to_light;
    vec3 arriving = incoming(lights[i], to_light);
    float n_dot_l = dot(normal, to_light);
    if (n_dot_l <= 0.0 || arriving == vec3(0.0)) continue;
    arriving *= shadow(lights[i], normal, n_dot_l);
    vec3 halfway = normalize(to_light + to_eye);
    float n_dot_h = max(dot(normal, halfway), 0.0);
    float v_dot_h = max(dot(to_eye, halfway), 0.0);
    // Lights are given so that a white matte surface facing one of intensity 1 is just white: pi is
    // left out of the diffuse term, and put back into the specular one.
    vec3 shine = kPi * specular(f0, alpha, n_dot_l, n_dot_v, n_dot_h, v_dot_h);
    sum += arriving * n_dot_l * (matte + shine);
  }
  colour = vec4(shoulder(sum), base.a);
}

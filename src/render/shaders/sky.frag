#version 450 core
// The sky in the direction of each pixel: sunlight scattered once by air and haze (the closed form for
// a flat atmosphere, Chandrasekhar 1950, "Radiative Transfer", section 48), and what is scattered
// again, as if it came evenly from all around; clouds are noise on a flat layer.

const float kPi = 3.14159265;

#ifdef PANORAMA
uniform vec4 picture_size;   // [px]
#else
uniform mat4 world_from_camera;
uniform vec4 intrinsics;     // fx, fy, cx, cy [px]
uniform float exposure;      // multiplies all light
#endif
uniform vec3 sun_W;          // towards the sun, unit length
uniform vec3 sunlight;       // before the atmosphere; 0 at night
uniform vec3 night;          // what is left without the sun
uniform vec3 air;            // optical thickness of air upwards, for red, green and blue
uniform float haze;          // the same of haze
uniform float sun_air_mass;  // how many times the thickness upwards lies before the sun

#ifdef CLOUDS
uniform vec3 cloud_colour;
uniform float cloud_cover;  // 0 none .. 1 everywhere
uniform float cloud_scale;  // lumps in the layer's height
#endif

layout(location = 0) out vec4 colour;

// Thicknesses of the atmosphere in a direction, 1 upwards (Kasten and Young 1989).
float airMass(float sine) {
  float s = clamp(sine, 0.0, 1.0);
  return 1.0 / (s + 0.50572 * pow(6.07995 + degrees(asin(s)), -1.6364));
}

// Henyey and Greenstein's phase function: haze scatters forwards.
float forwardPhase(float cosine) {
  const float g = 0.76;
  return (1.0 - g * g) / (4.0 * kPi * pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

vec3 clearSky(vec3 direction) {
  float seen = airMass(direction.z);
  float cosine = dot(direction, sun_W);
  vec3 thickness = air + haze;
  vec3 phase = (air * 3.0 / (16.0 * kPi) * (1.0 + cosine * cosine) + haze * forwardPhase(cosine)) /
               thickness;
  float apart = seen - sun_air_mass;
  if (abs(apart) < 0.01) apart = 0.01;  // the form's limit, closely enough
  float shown = sun_air_mass + apart;
  vec3 once = phase * shown / apart * (exp(-thickness * sun_air_mass) - exp(-thickness * shown));
  vec3 again = 0.5 / (4.0 * kPi) * (1.0 - exp(-air * sun_air_mass)) * (1.0 - exp(-thickness * seen));
  return sunlight * (once + again) + night;
}

#ifdef CLOUDS
// A number from 0 to 1 for each point of a grid (the finaliser of MurmurHash3, public domain).
float gridNoise(ivec2 point) {
  uint h = uint(point.x) * 0x9E3779B1u ^ uint(point.y) * 0x85EBCA77u;
  h ^= h >> 16;
  h *= 0x85EBCA6Bu;
  h ^= h >> 13;
  h *= 0xC2B2AE35u;
  h ^= h >> 16;
  return float(h & 0xFFFFFFu) / 16777215.0;
}

float smoothNoise(vec2 place) {
  vec2 cell = floor(place);
  vec2 f = place - cell;
  f = f * f * (3.0 - 2.0 * f);
  ivec2 i = ivec2(cell);
  return mix(mix(gridNoise(i), gridNoise(i + ivec2(1, 0)), f.x),
             mix(gridNoise(i + ivec2(0, 1)), gridNoise(i + ivec2(1, 1)), f.x), f.y);
}

// Noise upon noise, each octave turned and finer.
float lumps(vec2 place) {
  const mat2 kTurn = mat2(1.6, 1.2, -1.2, 1.6);
  float sum = 0.0;
  float weight = 0.5;
  for (int octave = 0; octave < 5; ++octave) {
    sum += weight * smoothNoise(place);
    place = kTurn * place;
    weight *= 0.5;
  }
  return sum / 0.96875;
}

float cloudDensity(vec2 place) {
  float edge = mix(0.85, 0.05, cloud_cover);
  return smoothstep(edge, edge + 0.3, lumps(place));
}

vec3 withClouds(vec3 clear, vec3 direction) {
  // The layer bends down with the earth, so that its far end does not shrink to nothing.
  vec2 place = direction.xy / (direction.z + 0.12) * cloud_scale;
  float density = cloudDensity(place);
  // Thick places are darker, less so where the next place towards the sun is thinner.
  float towards_sun = cloudDensity(place + 0.25 * sun_W.xy);
  // What is far merges into one veil.
  float near = smoothstep(0.0, 0.15, direction.z);
  density = mix(cloud_cover * cloud_cover, density, near);
  towards_sun = mix(cloud_cover, towards_sun, near);
  vec3 through = exp(-(air + haze) * sun_air_mass);
  vec3 sunny = sunlight / (4.0 * kPi) * through * mix(1.6, 0.8, towards_sun);
  vec3 cloud = cloud_colour * (sunny * 1.1 + night * 4.0) + 0.15 * clear;
  return mix(clear, cloud, density);
}
#endif

vec3 skyAlong(vec3 direction, float sun_disc) {
  vec3 above = normalize(vec3(direction.xy, max(direction.z, 0.0)));
  vec3 seen = clearSky(above);
  seen += sun_disc * 20.0 * sunlight * exp(-(air + haze) * sun_air_mass);
#ifdef CLOUDS
  seen = withClouds(seen, above);
#endif
  // Below the horizon lies land in the haze.
  float below = smoothstep(0.0, 0.5, -direction.z);
  return seen * mix(vec3(1.0), vec3(0.35, 0.33, 0.3), below);
}

#ifdef PANORAMA
// All of the sky as an equirectangular picture, as light: without the sun, which is a light of its
// own.
void main() {
  vec2 place = gl_FragCoord.xy / picture_size.xy;
  float azimuth = kPi * (1.0 - 2.0 * place.x);
  float elevation = kPi * (0.5 - place.y);
  vec3 direction = vec3(cos(elevation) * vec2(cos(azimuth), sin(azimuth)), sin(elevation));
  colour = vec4(skyAlong(direction, 0.0), 1.0);
}
#else
#include "shown.glsl"

vec3 shoulder(vec3 linear) {
  return mix(linear, 0.8 + 0.2 * (1.0 - exp(-(linear - 0.8) / 0.2)), greaterThan(linear, vec3(0.8)));
}

void main() {
  // A pixel's centre, whole in OpenCV's convention, is half past in OpenGL's.
  vec2 pixel = gl_FragCoord.xy - 0.5;
  vec3 ray_C = vec3((pixel - intrinsics.zw) / intrinsics.xy, 1.0);
  vec3 direction = normalize(mat3(world_from_camera) * ray_C);
  float disc = smoothstep(0.99998, 0.999992, dot(direction, sun_W));  // half a degree wide
  disc *= step(0.0, direction.z);
  colour = vec4(shown(shoulder(exposure * skyAlong(direction, disc))), 1.0);
}
#endif

#include "render/light/surface_shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// Light and where it comes from.
struct Arriving {
  Lanes3 to_light;
  Lanes distance;
  Lanes3 light;
};

/// How much of a spot light's middle arrives at its edge.
Lanes withinCone(const LightInView& light, const Lanes& cosine) {
  const float edge = std::max(light.cone.x() - light.cone.y(), 1e-4F);
  const Lanes inside = clamped((cosine - lanes(light.cone.y())) / lanes(edge), 0.0F, 1.0F);
  std::array<float, kLaneCount> shares{};
  cv::v_store(shares.data(), inside);
  for (float& share : shares) share = std::pow(share, std::max(light.cone.z(), 1e-3F));
  return cv::v_load(shares.data());
}

Arriving arriving(const LightInView& light, const Lanes3& position_C) {
  if (light.type == world::LightType::kDirectional) {
    return {lanes(-light.direction_C), lanes(0.0F), lanes(light.intensity)};
  }
  const Lanes3 way = lanes(light.position_C) - position_C;
  const Lanes d = length(way);
  const Lanes3 to_light = way * (lanes(1.0F) / cv::v_max(d, lanes(1e-6F)));
  const Lanes fading = lanes(light.attenuation.x()) + lanes(light.attenuation.y()) * d +
                       lanes(light.attenuation.z()) * d * d;
  Lanes falling = lanes(1.0F) / cv::v_max(fading, lanes(1e-6F));
  if (light.type == world::LightType::kSpot) {
    falling *= withinCone(light, lanes(0.0F) - dot(to_light, lanes(light.direction_C)));
  }
  falling = falling & (d <= lanes(light.range));
  return {to_light, d, lanes(light.intensity) * falling};
}

Lanes3 fresnel(const Lanes3& f0, const Lanes& cosine) {
  const Lanes x = lanes(1.0F) - cosine;
  const Lanes x2 = x * x;
  return f0 + (lanes(1.0F, 1.0F, 1.0F) - f0) * (x2 * x2 * x);
}

/// Linear up to 0.8, then bending towards 1 so that bright surfaces keep their drawing.
Lanes shoulder(const Lanes& linear) {
  constexpr float kStart = 0.8F;
  constexpr float kRest = 1.0F - kStart;
  const Lanes is_bright = linear > lanes(kStart);
  if (!cv::v_check_any(is_bright)) return linear;
  const Lanes fading = exponential((lanes(kStart) - linear) * lanes(1.0F / kRest));
  return cv::v_select(is_bright, lanes(1.0F) - lanes(kRest) * fading, linear);
}

}  // namespace

SurfaceShading::SurfaceShading(const Surroundings& surroundings)
    : surroundings_(surroundings), lookups_(surroundings.lights.size()) {
  if (surroundings.fog) {
    fog_light_ = surroundings.exposure * linearFromSrgb(surroundings.fog->colour);
  }
  for (std::size_t i = 0; i < lookups_.size(); ++i) {
    const std::optional<CastShadow>& shadow = surroundings.shadows[i];
    if (!shadow) continue;
    maps_.push_back(shadow->map.assemble());
    lookups_[i].emplace(maps_.back().depths(), shadow->shadow_from_camera, shadow->texel,
                        surroundings.lights[i].type == world::LightType::kSpot);
  }
}

Lanes3 SurfaceShading::seen(const SurfaceLanes& surface) const {
  const Lanes exposure = lanes(surroundings_.exposure);
  Lanes3 light = lit(surface) * exposure;
  light = {shoulder(light.x), shoulder(light.y), shoulder(light.z)};
  light = select(surface.is_lit, light, surface.base * exposure);
  if (surroundings_.fog) {
    light = mix(light, lanes(fog_light_), fogginess(length(surface.position_C)));
  }
  const Lanes one = lanes(1.0F);
  return {cv::v_min(light.x, one), cv::v_min(light.y, one), cv::v_min(light.z, one)};
}

/// The light that a surface sends to the eye.
Lanes3 SurfaceShading::lit(const SurfaceLanes& surface) const {
  const Lanes one = lanes(1.0F);
  Response response;
  response.to_eye = normalized(lanes(0.0F, 0.0F, 0.0F) - surface.position_C);
  response.f0 = mix({surface.reflectance, surface.reflectance, surface.reflectance}, surface.base,
                    surface.metalness);
  response.matte = surface.base * (one - surface.metalness);
  response.alpha = cv::v_max(surface.roughness * surface.roughness, lanes(0.01F));
  response.n_dot_v = cv::v_max(dot(surface.normal, response.to_eye), lanes(1e-3F));

  const Lanes half = lanes(0.5F);
  const Lanes sky = half + half * dot(surface.normal, lanes(surroundings_.up_C));
  const Lanes3 around = lanes(surroundings_.ambient) * mix(lanes(0.55F), one, sky);
  const Lanes3 reflected =
      fresnel(response.f0, response.n_dot_v) * mix(one, lanes(0.4F), surface.roughness);
  Lanes3 sum = around * (response.matte + reflected) + surface.glow;
  for (std::size_t i = 0; i < lookups_.size(); ++i) sum = sum + sent(i, surface, response);
  return sum;
}

/// What of one light a surface sends to the eye.
Lanes3 SurfaceShading::sent(std::size_t light, const SurfaceLanes& surface,
                            const Response& response) const {
  const Lanes zero = lanes(0.0F);
  const Arriving coming = arriving(surroundings_.lights[light], surface.position_C);
  const Lanes n_dot_l = dot(surface.normal, coming.to_light);
  const Lanes face_dot_l = dot(surface.face, coming.to_light);
  const Lanes faces = (n_dot_l > zero) & (face_dot_l > zero);
  if (!cv::v_check_any(faces)) return {zero, zero, zero};
  Lanes passing = n_dot_l;
  if (const std::optional<ShadowLookup>& shadow = lookups_[light]) {
    passing *=
        shadow->passing(surface.position_C, surface.face, face_dot_l, coming.distance, faces);
  }
  const Lanes3 halfway = normalized(coming.to_light + response.to_eye);
  const Lanes n_dot_h = cv::v_max(dot(surface.normal, halfway), zero);
  const Lanes v_dot_h = cv::v_max(dot(response.to_eye, halfway), zero);
  const Lanes& alpha = response.alpha;
  const Lanes& n_dot_v = response.n_dot_v;
  const Lanes a2 = alpha * alpha;
  const Lanes bell = n_dot_h * n_dot_h * (a2 - lanes(1.0F)) + lanes(1.0F);
  const Lanes rough = mix(lanes(2.0F) * n_dot_l * n_dot_v, n_dot_l + n_dot_v, alpha);
  // Lights are given so that a white matte surface facing one of intensity 1 is just white: pi is
  // left out of the diffuse term, and put back into the specular one, which is divided by it.
  const Lanes shine = lanes(0.5F) * a2 / (bell * bell * rough);
  const Lanes3 answer = response.matte + fresnel(response.f0, v_dot_h) * shine;
  // Where it does not face the light, the answer may be infinite.
  return select(faces, coming.light * answer * passing, {zero, zero, zero});
}

/// The share of the fog in what is seen at a distance [m] from the camera. (OGRE takes the depth
/// along the axis instead, so that its fog changes where a camera turns.)
Lanes SurfaceShading::fogginess(const Lanes& distance) const {
  const world::Fog& fog = *surroundings_.fog;
  const Lanes one = lanes(1.0F);
  if (fog.type == world::FogType::kLinear) {
    const auto end = static_cast<float>(fog.end);
    const auto way = static_cast<float>(std::max(fog.end - fog.start, 1e-6));
    return one - clamped((lanes(end) - distance) / lanes(way), 0.0F, 1.0F);
  }
  Lanes thickness = lanes(static_cast<float>(fog.density)) * distance;
  if (fog.type != world::FogType::kExponential) thickness *= thickness;
  return one - exponential(lanes(0.0F) - thickness);
}

}  // namespace synthetic_dataset::render

#include "render/light/arriving_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "render/shadows/shadow_projection.h"

namespace synthetic_dataset::render {
namespace {

/// The share of a spot light's intensity that remains at an angle from its axis.
Lanes withinCone(const LightInView& light, const Lanes& cosine) {
  const float edge = std::max(light.cone.x() - light.cone.y(), 1e-4F);
  const Lanes inside = clamped((cosine - lanes(light.cone.y())) / lanes(edge), 0.0F, 1.0F);
  if (light.cone.z() == 1.0F) return inside;
  std::array<float, kLaneCount> shares{};
  cv::v_store(shares.data(), inside);
  for (float& share : shares) share = std::pow(share, std::max(light.cone.z(), 1e-3F));
  return cv::v_load(shares.data());
}

/// If a world has more lights than this, their light is left out where it is too weak to be seen.
constexpr std::size_t kManyLights = 32;

/// How far a light shines [m]: up to its range and, if there are many lights, only as far as it
/// adds something that could be seen even in the sum of hundreds.
float reachOf(const LightInView& light, bool is_one_of_many) {
  constexpr float kUnseen = 1e-4F;  // a share of the light of a white surface
  if (light.type == world::LightType::kDirectional) return std::numeric_limits<float>::infinity();
  if (!is_one_of_many) return light.range;
  // intensity / (c + l d + q d^2) = kUnseen
  const float c = light.attenuation.x() - light.intensity.maxCoeff() / kUnseen;
  const float l = light.attenuation.y();
  const float q = light.attenuation.z();
  if (c >= 0.0F) return 0.0F;
  if (q > 0.0F) return std::min(light.range, (std::sqrt(l * l - 4.0F * q * c) - l) / (2.0F * q));
  return l > 0.0F ? std::min(light.range, -c / l) : light.range;
}

}  // namespace

ArrivingLights::ArrivingLights(const LightingContext& context)
    : context_(context), lookups_(context.lights.size()) {
  for (std::size_t i = 0; i < lookups_.size(); ++i) {
    reaches_.push_back(reachOf(context.lights[i], lookups_.size() > kManyLights));
    const bool from_point = context.lights[i].type != world::LightType::kDirectional;
    for (const CastShadow& shadow : context.shadows[i]) {
      maps_.push_back(shadow.map.assemble(shadow.isSoft()));
      lookups_[i].emplace_back(shadow, maps_.back(), from_point);
    }
  }
}

std::vector<std::size_t> ArrivingLights::all() const {
  std::vector<std::size_t> lights(lookups_.size());
  std::iota(lights.begin(), lights.end(), std::size_t{0});
  return lights;
}

bool ArrivingLights::areMany() const {
  constexpr std::size_t kFew = 4;
  return lookups_.size() > kFew;
}

void ArrivingLights::reaching(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                              std::vector<std::size_t>& lights) const {
  lights.clear();
  for (std::size_t i = 0; i < reaches_.size(); ++i) {
    const Eigen::Vector3f& light_C = context_.lights[i].position_C;
    const Eigen::Vector3f nearest_C = light_C.cwiseMax(low).cwiseMin(high);
    // Slightly more, so that rounding leaves none out.
    const float reach = reaches_[i] * 1.0001F;
    if ((nearest_C - light_C).squaredNorm() <= reach * reach) lights.push_back(i);
  }
}

Arriving ArrivingLights::at(std::size_t index, const Lanes3& position_C) const {
  const LightInView& light = context_.lights[index];
  if (light.type == world::LightType::kDirectional) {
    return {lanes(-light.direction_C), lanes(0.0F), lanes(1.0F)};
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
  return {to_light, d, falling & (d <= lanes(light.range))};
}

Lanes ArrivingLights::passing(std::size_t light, const Lanes3& position_C, const Lanes3& face,
                              const Arriving& coming, const Lanes& faces) const {
  const std::vector<ShadowLookup>& shadows = lookups_[light];
  if (shadows.empty()) return lanes(1.0F);
  const Lanes n_dot_l = dot(face, coming.to_light);
  if (shadows.size() == 1) {
    return shadows.front().passing(position_C, face, n_dot_l, coming.distance, faces);
  }
  // A point belongs to the cube's side along whose axis it is farthest.
  std::array<Lanes, kCubeSides> ahead;
  Lanes farthest = lanes(0.0F);
  for (std::size_t i = 0; i < ahead.size(); ++i) {
    ahead[i] = shadows[i].ahead(position_C);
    farthest = cv::v_max(farthest, ahead[i]);
  }
  Lanes result = lanes(1.0F);
  for (std::size_t i = 0; i < ahead.size(); ++i) {
    const ShadowLookup& side = shadows[i];
    const Lanes is_there = faces & (ahead[i] == farthest);
    if (!cv::v_check_any(is_there)) continue;
    result = cv::v_min(result, side.passing(position_C, face, n_dot_l, coming.distance, is_there));
  }
  return result;
}

Lanes ArrivingLights::fogginess(const Lanes& distance) const {
  const world::Fog& fog = *context_.fog;
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

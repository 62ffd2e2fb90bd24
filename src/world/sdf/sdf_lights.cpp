#include "world/sdf/sdf_lights.h"

namespace synthetic_dataset::world {
namespace {

LightType typeOf(const sdf::Light& light) {
  switch (light.Type()) {
    case sdf::LightType::POINT:
      return LightType::kPoint;
    case sdf::LightType::SPOT:
      return LightType::kSpot;
    default:
      return LightType::kDirectional;
  }
}

float intensityOf(const sdf::Light& light) {
  const sdf::ElementPtr on = descendant(light.Element(), {"light_on"});
  if (on && !on->Get<bool>()) return 0.0F;
  return static_cast<float>(number(light.Element(), {"intensity"}, 1.0));
}

bool isFinite(const Light& light) {
  return light.direction_L.allFinite() && light.diffuse.allFinite() && light.specular.allFinite() &&
         std::isfinite(light.range) && std::isfinite(light.attenuation_constant) &&
         std::isfinite(light.attenuation_linear) && std::isfinite(light.attenuation_quadratic) &&
         std::isfinite(light.spot_inner_angle) && std::isfinite(light.spot_outer_angle) &&
         std::isfinite(light.spot_falloff);
}

void check(const Light& light, const Place& place, SdfReading& reading) {
  if (!isFinite(light)) {
    reading.findings.addError(place.message("has a number that is not finite"));
  }
  if (light.type != LightType::kPoint && light.direction_L.norm() == 0.0) {
    reading.findings.addError(place.message("direction: found 0 0 0; it has to point somewhere"));
  }
  if (light.type != LightType::kDirectional && !(light.range > 0.0)) {
    reading.findings.addError(place.message(
        "attenuation range: found " + std::to_string(light.range) + "; it has to be above 0 m"));
  }
}

}  // namespace

Light readLight(const sdf::Light& light, const std::string& name, const Pose& X_WL,
                const Place& place, SdfReading& reading) {
  const Place here = place.in("light", light.Name());
  Light result;
  result.name = name;
  result.type = typeOf(light);
  result.X_WL = X_WL;
  result.direction_L = toEigen(light.Direction());
  result.diffuse = toColour(light.Diffuse()).head<3>() * intensityOf(light);
  result.specular = toColour(light.Specular()).head<3>() * intensityOf(light);
  result.casts_shadow = light.CastShadows();
  // Without <attenuation> Gazebo does not weaken the light.
  if (has(light.Element(), "attenuation")) {
    result.range = light.AttenuationRange();
    result.attenuation_constant = light.ConstantAttenuationFactor();
    result.attenuation_linear = light.LinearAttenuationFactor();
    result.attenuation_quadratic = light.QuadraticAttenuationFactor();
  }
  if (result.type == LightType::kSpot) {
    result.spot_inner_angle = light.SpotInnerAngle().Radian();
    result.spot_outer_angle = light.SpotOuterAngle().Radian();
    result.spot_falloff = light.SpotFalloff();
  }
  check(result, here, reading);
  return result;
}

}  // namespace synthetic_dataset::world

#include "world/sdf/sdf_lights.h"

#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

LightType readType(const Element& light, const SourceLocation& location, SdfReading& reading) {
  const std::string type = light.attribute("type");
  if (type == "directional") return LightType::kDirectional;
  if (type == "spot") return LightType::kSpot;
  if (type != "point" && !type.empty()) {
    reading.findings.addNote(
        location,
        "type: found '" + type + "'; it should be directional, point or spot; point is taken");
  }
  return LightType::kPoint;
}

float intensityOf(const Element& light, const SourceLocation& location, SdfReading& reading) {
  if (!readBool(light, "light_on", true, location, reading)) return 0.0F;
  return static_cast<float>(readNumber(light, "intensity", 1.0, location, reading));
}

/// Without <attenuation> Gazebo does not weaken the light.
void readAttenuation(const Element& light, const SourceLocation& location, SdfReading& reading,
                     Light& to) {
  const Element attenuation = light.child("attenuation");
  if (!attenuation) return;
  const auto number = [&](const char* name, double fallback) {
    return readNumber(attenuation, name, fallback, location, reading);
  };
  to.attenuation_constant = number("constant", 1.0);
  to.attenuation_linear = number("linear", 1.0);
  to.attenuation_quadratic = number("quadratic", 0.0);
  const double range = number("range", 10.0);
  if (range > 0.0) {
    to.range = range;
  } else if (to.type != LightType::kDirectional) {
    reading.findings.addNote(location, "attenuation range: found " + shortText(range) +
                                           "; it has to be above 0 m; " + takenInstead(to.range));
  }
}

void readDirection(const Element& light, const SourceLocation& location, SdfReading& reading,
                   Light& to) {
  const Eigen::Vector3d direction = readVector(light, "direction", {0, 0, -1}, location, reading);
  if (direction.norm() > 0.0) {
    to.direction_L = direction;
  } else if (to.type != LightType::kPoint) {
    reading.findings.addNote(location,
                             "direction: found 0 0 0; it has to point somewhere; 0 0 -1 is taken");
  }
}

}  // namespace

Light readLight(const Element& light, const std::string& name, const Pose& X_WL,
                const SourceLocation& location, SdfReading& reading) {
  Light result;
  result.name = name;
  result.type = readType(light, location, reading);
  result.X_WL = X_WL;
  readDirection(light, location, reading, result);
  const float intensity = intensityOf(light, location, reading);
  const auto colour = [&](const char* element, const Eigen::Vector3f& fallback) {
    const auto found = readColour(light, element, location, reading);
    return Eigen::Vector3f(intensity * (found ? found->head<3>() : fallback));
  };
  result.diffuse = colour("diffuse", result.diffuse);
  result.specular = colour("specular", result.specular);
  result.casts_shadow = readBool(light, "cast_shadows", false, location, reading);
  readAttenuation(light, location, reading, result);
  if (result.type == LightType::kSpot) {
    const Element spot = light.child("spot");
    result.spot_inner_angle = readNumber(spot, "inner_angle", 0.0, location, reading);
    result.spot_outer_angle = readNumber(spot, "outer_angle", 0.0, location, reading);
    result.spot_falloff = readNumber(spot, "falloff", 0.0, location, reading);
  }
  return result;
}

}  // namespace synthetic_dataset::world

#include "world/sdf/sdf_scene.h"

#include <algorithm>
#include <optional>
#include <string>

#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

Eigen::Vector3f colourOr(const Element& parent, const char* name, const Eigen::Vector3f& fallback,
                         const SourceLocation& location, SdfReading& reading) {
  const auto colour = readColour(parent, name, location, reading);
  return colour ? Eigen::Vector3f(colour->head<3>()) : fallback;
}

double positiveOr(const Element& parent, const char* name, double fallback,
                  const SourceLocation& location, SdfReading& reading) {
  const double value = readNumber(parent, name, fallback, location, reading);
  if (value >= 0.0) return value;
  reading.findings.addNote(location, std::string(name) + ": found " + shortText(value) +
                                         "; it has to be 0 or more; " + takenInstead(fallback));
  return fallback;
}

/// How Gazebo's renderer understands the names; nothing for a name that it does not know.
std::optional<FogType> fogType(const std::string& name) {
  if (name == "linear") return FogType::kLinear;
  if (name == "exp") return FogType::kExponential;
  if (name == "exp2" || name == "quadratic") return FogType::kSquaredExponential;
  return std::nullopt;
}

std::optional<Fog> readFog(const Element& element, const SourceLocation& location,
                           SdfReading& reading) {
  const std::string name = readText(element, "type");
  const std::optional<FogType> type = fogType(name);
  if (!type) {
    if (name != "none" && !name.empty()) {
      reading.findings.addNote(
          location, "type '" + name + "' is left out; linear, exp, exp2 and none are known");
    }
    return std::nullopt;
  }
  Fog fog;
  fog.type = *type;
  // SDF 1.0 writes <fog rgba="...">.
  fog.colour =
      colourOr(element, element.has("color") ? "color" : "rgba", fog.colour, location, reading);
  fog.start = positiveOr(element, "start", fog.start, location, reading);
  fog.end = positiveOr(element, "end", fog.end, location, reading);
  fog.density = positiveOr(element, "density", fog.density, location, reading);
  if (fog.type == FogType::kLinear && fog.end <= fog.start) {
    reading.findings.addNote(location, "end: found " + shortText(fog.end) +
                                           "; it has to lie beyond start, " + shortText(fog.start) +
                                           "; there is no fog");
    return std::nullopt;
  }
  return fog;
}

Sky readSky(const Element& element, const SourceLocation& location, SdfReading& reading) {
  Sky sky;
  sky.time = positiveOr(element, "time", sky.time, location, reading);
  sky.sunrise = positiveOr(element, "sunrise", sky.sunrise, location, reading);
  sky.sunset = positiveOr(element, "sunset", sky.sunset, location, reading);
  const Element clouds = element.child("clouds");
  if (!clouds) return sky;
  constexpr double kUsualHumidity = 0.5;  // SDF specification, <clouds>
  sky.cloud_humidity =
      std::min(1.0, positiveOr(clouds, "humidity", kUsualHumidity, location, reading));
  sky.cloud_mean_size =
      std::min(1.0, positiveOr(clouds, "mean_size", sky.cloud_mean_size, location, reading));
  sky.cloud_ambient = colourOr(clouds, "ambient", sky.cloud_ambient, location, reading);
  return sky;
}

}  // namespace

void readScene(const Element& scene, const SourceLocation& location, SdfReading& reading,
               Description& description) {
  description.ambient = colourOr(scene, "ambient", description.ambient, location, reading);
  description.background = colourOr(scene, "background", description.background, location, reading);
  if (const Element sky = scene.child("sky")) {
    description.sky = readSky(sky, locationOf(sky, location), reading);
  }
  if (const Element fog = scene.child("fog")) {
    description.fog = readFog(fog, locationOf(fog, location), reading);
  }
}

bool hasShadows(const Element& scene, const SourceLocation& location, SdfReading& reading) {
  return readBool(scene, "shadows", true, location, reading);
}

}  // namespace synthetic_dataset::world

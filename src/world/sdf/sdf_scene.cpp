#include "world/sdf/sdf_scene.h"

#include <algorithm>
#include <optional>
#include <string>

#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

Eigen::Vector3f colourOr(const Element& parent, const char* name, const Eigen::Vector3f& fallback,
                         const Place& place, SdfReading& reading) {
  const auto colour = readColour(parent, name, place, reading);
  return colour ? Eigen::Vector3f(colour->head<3>()) : fallback;
}

double positiveOr(const Element& parent, const char* name, double fallback, const Place& place,
                  SdfReading& reading) {
  const double value = readNumber(parent, name, fallback, place, reading);
  if (value >= 0.0) return value;
  reading.findings.addNote(place, std::string(name) + ": found " + shortText(value) +
                                      "; it has to be 0 or more; " + takenInstead(fallback));
  return fallback;
}

/// What Gazebo's renderer takes the names for; others it does not know.
std::optional<FogType> fogType(const std::string& name) {
  if (name == "linear") return FogType::kLinear;
  if (name == "exp") return FogType::kExponential;
  if (name == "exp2" || name == "quadratic") return FogType::kSquaredExponential;
  return std::nullopt;
}

std::optional<Fog> readFog(const Element& element, const Place& place, SdfReading& reading) {
  const std::string name = readText(element, "type");
  const std::optional<FogType> type = fogType(name);
  if (!type) {
    if (name != "none" && !name.empty()) {
      reading.findings.addNote(
          place, "type '" + name + "' is left out; linear, exp, exp2 and none are known");
    }
    return std::nullopt;
  }
  Fog fog;
  fog.type = *type;
  // SDF 1.0 says <fog rgba="...">.
  fog.colour =
      colourOr(element, element.has("color") ? "color" : "rgba", fog.colour, place, reading);
  fog.start = positiveOr(element, "start", fog.start, place, reading);
  fog.end = positiveOr(element, "end", fog.end, place, reading);
  fog.density = positiveOr(element, "density", fog.density, place, reading);
  if (fog.type == FogType::kLinear && fog.end <= fog.start) {
    reading.findings.addNote(place, "end: found " + shortText(fog.end) +
                                        "; it has to lie beyond start, " + shortText(fog.start) +
                                        "; there is no fog");
    return std::nullopt;
  }
  return fog;
}

Sky readSky(const Element& element, const Place& place, SdfReading& reading) {
  Sky sky;
  sky.time = positiveOr(element, "time", sky.time, place, reading);
  sky.sunrise = positiveOr(element, "sunrise", sky.sunrise, place, reading);
  sky.sunset = positiveOr(element, "sunset", sky.sunset, place, reading);
  const Element clouds = element.child("clouds");
  if (!clouds) return sky;
  constexpr double kUsualHumidity = 0.5;  // SDF specification, <clouds>
  sky.cloud_humidity =
      std::min(1.0, positiveOr(clouds, "humidity", kUsualHumidity, place, reading));
  sky.cloud_mean_size =
      std::min(1.0, positiveOr(clouds, "mean_size", sky.cloud_mean_size, place, reading));
  sky.cloud_ambient = colourOr(clouds, "ambient", sky.cloud_ambient, place, reading);
  return sky;
}

}  // namespace

void readScene(const Element& scene, const Place& place, SdfReading& reading,
               Description& description) {
  description.ambient = colourOr(scene, "ambient", description.ambient, place, reading);
  description.background = colourOr(scene, "background", description.background, place, reading);
  if (const Element sky = scene.child("sky")) {
    description.sky = readSky(sky, placeOf(sky, place), reading);
  }
  if (const Element fog = scene.child("fog")) {
    description.fog = readFog(fog, placeOf(fog, place), reading);
  }
}

bool hasShadows(const Element& scene, const Place& place, SdfReading& reading) {
  return readBool(scene, "shadows", true, place, reading);
}

}  // namespace synthetic_dataset::world

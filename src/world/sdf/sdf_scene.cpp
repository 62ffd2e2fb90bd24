#include "world/sdf/sdf_scene.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::world {
namespace {

/// A colour's red, green and blue, or the fallback where the file has none.
Eigen::Vector3f readColour(const sdf::ElementPtr& parent, const char* name,
                           const Eigen::Vector3f& fallback, const Place& place,
                           SdfReading& reading) {
  const sdf::ElementPtr element = descendant(parent, {name});
  if (!element) return fallback;
  const std::vector<double> values = numbers(element);
  if (values.size() >= 3) {
    const Eigen::Vector3d colour(values[0], values[1], values[2]);
    if (colour.allFinite()) return colour.cast<float>();
  }
  reading.findings.addError(place.message(std::string(name) + ": found '" +
                                          element->Get<std::string>() +
                                          "'; it has to be finite numbers: red green blue alpha"));
  return fallback;
}

/// A number that has to be finite and not below `least`.
double readNumber(const sdf::ElementPtr& parent, const char* name, double fallback, double least,
                  const Place& place, SdfReading& reading) {
  const double value = number(parent, {name}, fallback);
  if (std::isfinite(value) && value >= least) return value;
  reading.findings.addError(place.message(std::string(name) + ": found " + std::to_string(value) +
                                          "; it has to be " + std::to_string(least) + " or more"));
  return fallback;
}

/// What Gazebo's renderer takes the names for; others it does not know.
std::optional<FogType> fogType(const std::string& name) {
  if (name == "linear") return FogType::kLinear;
  if (name == "exp") return FogType::kExponential;
  if (name == "exp2" || name == "quadratic") return FogType::kSquaredExponential;
  return std::nullopt;
}

std::optional<Fog> readFog(const sdf::ElementPtr& element, const Place& place,
                           SdfReading& reading) {
  const sdf::ElementPtr named = descendant(element, {"type"});
  const std::string name = named ? named->Get<std::string>() : "none";
  const std::optional<FogType> type = fogType(name);
  if (!type) {
    if (name != "none") {
      reading.findings.addNote(
          place.message("type '" + name + "' is left out; linear, exp, exp2 and none are known"));
    }
    return std::nullopt;
  }
  Fog fog;
  fog.type = *type;
  fog.colour = readColour(element, "color", fog.colour, place, reading);
  fog.start = readNumber(element, "start", fog.start, 0.0, place, reading);
  fog.end = readNumber(element, "end", fog.end, 0.0, place, reading);
  fog.density = readNumber(element, "density", fog.density, 0.0, place, reading);
  if (fog.type == FogType::kLinear && fog.end <= fog.start) {
    reading.findings.addError(place.message("end: found " + std::to_string(fog.end) +
                                            "; it has to lie beyond start, " +
                                            std::to_string(fog.start)));
  }
  return fog;
}

Sky readSky(const sdf::ElementPtr& element, const Place& place, SdfReading& reading) {
  Sky sky;
  sky.time = readNumber(element, "time", sky.time, 0.0, place, reading);
  sky.sunrise = readNumber(element, "sunrise", sky.sunrise, 0.0, place, reading);
  sky.sunset = readNumber(element, "sunset", sky.sunset, 0.0, place, reading);
  const sdf::ElementPtr clouds = descendant(element, {"clouds"});
  if (!clouds) return sky;
  constexpr double kUsualHumidity = 0.5;  // SDF specification, <clouds>
  sky.cloud_humidity =
      std::min(1.0, readNumber(clouds, "humidity", kUsualHumidity, 0.0, place, reading));
  sky.cloud_mean_size =
      std::min(1.0, readNumber(clouds, "mean_size", sky.cloud_mean_size, 0.0, place, reading));
  sky.cloud_ambient = readColour(clouds, "ambient", sky.cloud_ambient, place, reading);
  return sky;
}

}  // namespace

void readScene(const sdf::ElementPtr& scene, const Place& place, SdfReading& reading,
               Description& description) {
  description.ambient = readColour(scene, "ambient", description.ambient, place, reading);
  description.background = readColour(scene, "background", description.background, place, reading);
  if (has(scene, "sky")) {
    description.sky = readSky(scene->GetElement("sky"), place.in("sky"), reading);
  }
  if (has(scene, "fog")) {
    description.fog = readFog(scene->GetElement("fog"), place.in("fog"), reading);
  }
}

bool hasShadows(const sdf::ElementPtr& scene) {
  const sdf::ElementPtr shadows = descendant(scene, {"shadows"});
  return !shadows || shadows->Get<bool>();
}

}  // namespace synthetic_dataset::world

#include "config/randomization.h"

#include "config/checked_values.h"
#include "config/distribution_config.h"

namespace synthetic_dataset::config {
namespace {

constexpr double kBrightest = 1e6;

std::optional<double> maybeProbability(const Parameters& group, const std::string& name) {
  const auto value = group.maybe<double>(name);
  if (!value || (*value >= 0.0 && *value <= 1.0)) return value;
  group.addError(name, "found " + Value(*value).text() + "; it should be a probability, 0 to 1");
  return std::nullopt;
}

LightRandomization readLight(const Parameters& group) {
  LightRandomization light;
  light.present = maybeProbability(group, "present");
  light.intensity = maybeDistribution(group, "intensity", {1, 0.0, kBrightest});
  light.colour = maybeDistribution(group, "colour", {3, 0.0, kBrightest});
  light.elevation = maybeDistribution(group, "elevation", kElevationRange);
  light.azimuth = maybeDistribution(group, "azimuth", kTurnRange);
  light.shift = maybeDistribution(group, "shift", kPlaceRange);
  return light;
}

bool readForEachVisual(const Parameters& group) {
  const std::string each = group.maybe<std::string>("for_each").value_or("visual");
  if (each != "visual" && each != "model") {
    group.addError("for_each", "found '" + each + "'; it should be visual or model");
  }
  return each != "model";
}

MaterialRandomization readMaterial(const Parameters& group) {
  MaterialRandomization material;
  material.for_each_visual = readForEachVisual(group);
  material.colour = maybeDistribution(group, "colour", {3, 0.0, 1.0});
  material.tint = maybeDistribution(group, "tint", {3, 0.0, 1.0});
  material.roughness = maybeDistribution(group, "roughness", {1, 0.0, 1.0});
  material.metalness = maybeDistribution(group, "metalness", {1, 0.0, 1.0});
  material.textures = group.maybe<std::string>("textures");
  if (material.textures && *material.textures != "procedural") {
    material.textures = absolutePath(*material.textures);
  }
  return material;
}

SensorRandomization readSensor(const Parameters& group) {
  constexpr double kMostStops = 10.0;
  constexpr double kWidestBlur = 50.0;  // [px]
  SensorRandomization sensor;
  sensor.exposure = maybeDistribution(group, "exposure", {1, -kMostStops, kMostStops});
  sensor.blur = maybeDistribution(group, "blur", {1, 0.0, kWidestBlur});
  sensor.noise_stddev = maybeDistribution(group, "noise_stddev", {1, 0.0, 1.0});
  return sensor;
}

}  // namespace

Randomization readRandomization(const Parameters& root) {
  Randomization randomization;
  if (!root.has("randomize")) return randomization;
  const Parameters group = root.group("randomize");
  const Parameters lights = group.group("lights");
  for (const std::string& name : lights.names()) {
    randomization.lights[name] = readLight(lights.group(name));
  }
  const Parameters objects = group.group("objects");
  for (const std::string& name : objects.names()) {
    const auto present = maybeProbability(objects.group(name), "present");
    if (present) randomization.present[name] = *present;
  }
  const Parameters materials = group.group("materials");
  for (const std::string& name : materials.names()) {
    randomization.materials[name] = readMaterial(materials.group(name));
  }
  randomization.distractors = readDistractors(group);
  randomization.ambient = maybeDistribution(group, "ambient", {3, 0.0, 1.0});
  randomization.background = maybeDistribution(group, "background", {3, 0.0, 1.0});
  randomization.sensor = readSensor(group.group("sensor"));
  return randomization;
}

}  // namespace synthetic_dataset::config

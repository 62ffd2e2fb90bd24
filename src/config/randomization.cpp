#include "config/readers.h"

#include "config/checked_values.h"
#include "config/distribution_config.h"

namespace synthetic_dataset::config {
namespace {

constexpr double kBrightestLight = 1e6;

randomize::LightRandomization readLight(Parameters group) {
  randomize::LightRandomization light;
  light.present = group.maybeBetween("present", 0.0, 1.0);
  light.intensity = maybeDistribution(group, "intensity", {1, 0.0, kBrightestLight});
  light.colour = maybeDistribution(group, "colour", {3, 0.0, kBrightestLight});
  light.elevation = maybeDistribution(group, "elevation", kElevationRange);
  light.azimuth = maybeDistribution(group, "azimuth", kTurnRange);
  light.shift = maybeDistribution(group, "shift", kPlaceRange);
  return light;
}

/// The number of lights or objects; nullopt if each is present or absent by itself.
/// @param kind  the name of their group
/// @param result  what each of the two conflicting entries determines
template <typename Entry>
std::optional<base::Distribution> readCount(Parameters& group, const std::string& name,
                                            const std::string& kind, const std::string& result,
                                            const std::map<std::string, Entry>& entries) {
  constexpr double kMost = 1000.0;  // the real limit is known later
  auto count = maybeDistribution(group, name, {1, 0.0, kMost});
  for (const auto& [own, entry] : entries) {
    if (!count || !entry.present) continue;
    group.addError(name, "found it beside " + kind + "/" + own +
                             "/present; it should be one of the two, since each says " + result);
  }
  return count;
}

randomize::MaterialRandomization readMaterial(Parameters group) {
  randomize::MaterialRandomization material;
  material.for_each_visual = choice<bool>(group, "for_each", {{"visual", true}, {"model", false}});
  material.colour = maybeDistribution(group, "colour", {3, 0.0, 1.0});
  material.tint = maybeDistribution(group, "tint", {3, 0.0, 1.0});
  material.roughness = maybeDistribution(group, "roughness", {1, 0.0, 1.0});
  material.metalness = maybeDistribution(group, "metalness", {1, 0.0, 1.0});
  material.textures = group.maybe<std::string>("textures");
  if (material.textures) material.textures = picturesFrom(*material.textures);
  return material;
}

std::optional<base::TextChoice> readModels(Parameters& group) {
  auto models = maybeChoice(group, "model");
  if (!models) return std::nullopt;
  for (std::string& model : models->texts) {
    if (model.rfind("param:", 0) == 0 || model.find('<') != std::string::npos) {
      group.addError("model",
                     "found a model that is not a file; if one of several is drawn, each "
                     "should be the path or URI of an SDF or URDF file");
      return std::nullopt;
    }
    model = pathOrUri(model);
  }
  return models;
}

/// @param usual  the default
std::optional<randomize::VarietyOptions> readVariety(Parameters& group,
                                                     const randomize::VarietyOptions& usual) {
  constexpr int kMostVariants = 100;
  randomize::VarietyOptions options = usual;
  const bool is_given = group.has("variety");
  const auto given = choice<randomize::Variety>(group, "variety",
                                                {{"none", randomize::Variety::kNone},
                                                 {"same_object", randomize::Variety::kSameObject},
                                                 {"same_class", randomize::Variety::kSameClass}});
  if (is_given) options.variety = given;
  if (options.variety != randomize::Variety::kNone) {
    options.variants = group.optionalBetween("variants", usual.variants, 1, kMostVariants);
  } else if (group.has("variants")) {
    group.addError("variants",
                   "has a meaning beside variety: same_object or same_class: how many variants "
                   "are made");
    group.ignore("variants");
  }
  if (!is_given && options.variants == usual.variants) return std::nullopt;
  return options;
}

/// @param variety  the default of objects without their own
randomize::ObjectRandomization readObject(Parameters group,
                                          const randomize::VarietyOptions& variety) {
  constexpr double kSmallest = 1e-3;
  constexpr double kLargest = 1e3;
  constexpr int kMostSizes = 100;
  randomize::ObjectRandomization object;
  object.present = group.maybeBetween("present", 0.0, 1.0);
  object.model = readModels(group);
  object.scale = maybeDistribution(group, "scale", {1, kSmallest, kLargest});
  if (object.scale && object.scale->values().empty()) {
    object.sizes = group.optionalBetween("sizes", object.sizes, 1, kMostSizes);
  } else if (group.has("sizes")) {
    group.addError("sizes",
                   "has a meaning beside a scale that is drawn from a range: how many "
                   "sizes are made of it");
    group.ignore("sizes");
  }
  object.variety = readVariety(group, variety);
  return object;
}

randomize::SensorRandomization readSensor(Parameters group) {
  constexpr double kMostStops = 10.0;
  constexpr double kWidestBlur = 50.0;  // [px]
  randomize::SensorRandomization sensor;
  sensor.exposure = maybeDistribution(group, "exposure", {1, -kMostStops, kMostStops});
  sensor.blur = maybeDistribution(group, "blur", {1, 0.0, kWidestBlur});
  sensor.noise_stddev = maybeDistribution(group, "noise_stddev", {1, 0.0, 1.0});
  sensor.white_balance =
      maybeDistribution(group, "white_balance", {1, render::kReddestLight, render::kBluestLight});
  sensor.jpeg_quality = maybeDistribution(group, "jpeg_quality", {1, 1.0, 100.0});
  // A fisheye may see all around; the limit of each camera's lens is known later.
  constexpr double kNarrowestView = 0.01;  // [rad]
  sensor.field_of_view =
      maybeDistribution(group, "field_of_view", {1, kNarrowestView, 2.0 * kHalfTurn, false, true});
  return sensor;
}

randomize::WeatherRandomization readWeather(Parameters group) {
  constexpr double kNearest = 1.0;         // [m]
  constexpr double kFarthest = 1e6;        // [m]
  constexpr double kHeaviestRain = 500.0;  // [mm/h]
  constexpr double kHeaviestSnow = 20.0;   // [mm/h]; in denser snow nothing is visible
  constexpr double kStrongest = 100.0;     // [m/s]
  constexpr double kDustiest = 0.2;        // share of the glass
  randomize::WeatherRandomization weather;
  weather.present = group.maybeBetween("present", 0.0, 1.0);
  weather.visibility = maybeDistribution(group, "visibility", {1, kNearest, kFarthest});
  weather.rain = maybeDistribution(group, "rain", {1, 0.0, kHeaviestRain});
  weather.snow = maybeDistribution(group, "snow", {1, 0.0, kHeaviestSnow});
  weather.wind = maybeDistribution(group, "wind", {3, -kStrongest, kStrongest, true});
  weather.colour = maybeDistribution(group, "colour", {3, 0.0, 1.0});
  weather.dust = maybeDistribution(group, "dust", {1, 0.0, kDustiest});
  if (!group.has("visibility") && !group.has("rain") && !group.has("snow")) {
    refuseWithout(group, {"present", "wind", "colour"}, "visibility, rain or snow");
  }
  return weather;
}

}  // namespace

randomize::Randomization readRandomization(Parameters root) {
  randomize::Randomization randomization;
  if (!root.has("randomize")) return randomization;
  Parameters group = root.group("randomize");
  // Expanded before settings are read, if it applies (run/setup/transfer_preset.h).
  (void)group.maybeChoice("preset", {"transfer"});
  Parameters lights = group.group("lights");
  for (const std::string& name : lights.names()) {
    randomization.lights[name] = readLight(lights.group(name));
  }
  randomization.light_count =
      readCount(group, "light_count", "lights", "which lights are on", randomization.lights);
  randomization.variety = readVariety(group, {}).value_or(randomization.variety);
  Parameters objects = group.group("objects");
  for (const std::string& name : objects.names()) {
    randomization.objects[name] = readObject(objects.group(name), randomization.variety);
  }
  randomization.object_count =
      readCount(group, "object_count", "objects", "which objects are there", randomization.objects);
  Parameters materials = group.group("materials");
  for (const std::string& name : materials.names()) {
    randomization.materials[name] = readMaterial(materials.group(name));
  }
  randomization.room = readRoom(group);
  randomization.distractors = readDistractors(group);
  randomization.ambient = maybeDistribution(group, "ambient", {3, 0.0, 1.0});
  randomization.background = readBackground(group);
  randomization.sensor = readSensor(group.group("sensor"));
  randomization.weather = readWeather(group.group("weather"));
  constexpr double kLongest = 1e6;  // [s]; the time from scene to scene is the real limit
  Parameters time = group.group("time");
  randomization.time_jitter = maybeDistribution(time, "jitter", {1, -kLongest, kLongest});
  return randomization;
}

}  // namespace synthetic_dataset::config

#include "scene/scene_variation.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "base/diagnostics.h"
#include "base/json_text.h"
#include "base/random/random_seed.h"
#include "scene/field_of_view.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::scene {
namespace {

const char* const kFieldOfView = "randomize/sensor/field_of_view";

Value valueOf(const randomize::DrawnValue& drawn) {
  if (const auto* text = std::get_if<std::string>(&drawn.value)) return Value(*text);
  const auto& numbers = std::get<std::vector<double>>(drawn.value);
  if (numbers.size() == 1) return Value(numbers.front());
  return Value(Value::List(numbers.begin(), numbers.end()));
}

}  // namespace

SceneVariation::SceneVariation(const SceneOptions& config, const std::vector<CameraRig>& cameras,
                               std::vector<ObjectVariants> variants, const world::World& world,
                               base::Diagnostics& diagnostics)
    : config_(config.randomization),
      seed_(static_cast<std::uint64_t>(config.seed)),
      is_placed_(config.isPlaced()),
      objects_(config.objects.begin(),
               config.objects.begin() + static_cast<std::ptrdiff_t>(config.robotCount())),
      variants_(std::move(variants)),
      cameras_(cameras.size()) {
  for (const CameraRig& camera : cameras) {
    effects_.push_back(camera.effects);
    models_.push_back(camera.model);
  }
  base::Diagnostics errors;
  errors.attempt([&] {
    const auto& field_of_view = config_.sensor.field_of_view;
    if (!field_of_view) return;
    checkFieldOfView(*field_of_view, kFieldOfView, cameras);
    warnOfBlackEdges(*field_of_view, kFieldOfView, cameras, diagnostics);
  });
  errors.attempt([&] {
    if (config_.changesLook()) looks_.emplace(config_, world);
  });
  std::vector<std::string> names;
  for (const ObjectOptions& object : objects_) names.push_back(object.name);
  for (const auto& [name, entry] : config_.objects) {
    if (name == randomize::kOthers || std::count(names.begin(), names.end(), name) > 0) continue;
    errors.error("randomize/objects/" + name,
                 "robot_list has no object of this name" + didYouMean(name, names));
  }
  for (const ObjectOptions& object : objects_) {
    if (!object.stands || config_.objects.count(object.name) == 0) continue;
    errors.error("randomize/objects/" + object.name,
                 "found for an object that stands in the world; it is there in each scene, in its "
                 "one shape and size, and materials/" +
                     object.name + " paints it");
  }
  errors.throwIfAny();
}

void SceneVariation::choose(std::int64_t instant, world::World& world) {
  randomize::EntryDraws draws(seed_, instant);
  std::vector<bool> present = choosePresent(draws);
  std::vector<std::size_t> variants;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const ObjectOptions& object = objects_[i];
    const auto share = config_.ofObject(object.name).present;
    if (object.takes_part && share && !object.stands) {
      present[i] = draws.happens("objects/" + object.name + "/present", *share);
    }
    variants.push_back(variants_[i].draw(draws));
  }
  world.setPresent(present);
  world.setVariants(variants);
  chosen_ = draws.values();
}

/// Chooses the objects that are present: those that take part. If a count is drawn, a random subset
/// of that size, which does not apply to objects that stand in the world.
std::vector<bool> SceneVariation::choosePresent(randomize::EntryDraws& draws) const {
  std::vector<bool> present;
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    present.push_back(objects_[i].takes_part);
    if (objects_[i].takes_part && !objects_[i].stands) candidates.push_back(i);
  }
  if (!config_.object_count) return present;
  const std::string entry = "object_count";
  base::RandomSource counting = draws.source(entry);
  const auto wanted =
      static_cast<std::size_t>(std::lround(config_.object_count->drawNumber(counting)));
  const std::size_t count = std::min(wanted, candidates.size());
  draws.note(entry, static_cast<double>(count));
  base::RandomSource shuffling = draws.source(entry + "/objects");
  const std::vector<std::size_t> order = shuffling.choice(candidates.size(), candidates.size());
  for (std::size_t i = count; i < order.size(); ++i) present[candidates[order[i]]] = false;
  return present;
}

void SceneVariation::vary(std::int64_t instant, render::Renderer& renderer,
                          std::vector<CameraRig>& cameras) {
  randomize::EntryDraws shared(seed_, instant);
  if (looks_) {
    const world::Look look = looks_->sample(shared);
    renderer.setLook(look);
    materials_ = look.materials;
  }
  const render::Weather air = weather(shared);
  shared_ = shared.values();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    randomize::EntryDraws draws(seed_, instant, cameras[i].name);
    cameras[i].weather = air;
    cameras[i].effects = varied(effects_[i], draws);
    const auto angle = draws.number("sensor/field_of_view", config_.sensor.field_of_view);
    if (angle) cameras[i].model = withFieldOfView(models_[i], *angle);
    cameras_[i] = draws.values();
    cameras[i].dust = dust(instant, cameras[i].name, cameras_[i]);
  }
}

/// In a recording, a camera's lens has the same dust in all scenes; independent scenes each have
/// dust of their own.
/// @param drawn  receives what was drawn
render::LensDust SceneVariation::dust(std::int64_t instant, const std::string& camera,
                                      std::vector<randomize::DrawnValue>& drawn) const {
  const std::int64_t of = is_placed_ ? instant : 0;
  randomize::EntryDraws draws(seed_, of, camera);
  const auto share = draws.number("weather/dust", config_.weather.dust);
  if (!share) return {};
  drawn.push_back(draws.values().front());
  return {*share, base::randomSeed(seed_, of, "dust on " + camera)};
}

/// The weather, which all cameras share.
render::Weather SceneVariation::weather(randomize::EntryDraws& draws) const {
  const randomize::WeatherRandomization& entries = config_.weather;
  if (!entries.changesAir()) return {};
  if (entries.present && !draws.happens("weather/present", *entries.present)) return {};
  render::Weather weather;
  weather.visibility =
      draws.number("weather/visibility", entries.visibility).value_or(weather.visibility);
  weather.rain = draws.number("weather/rain", entries.rain).value_or(0.0);
  weather.snow = draws.number("weather/snow", entries.snow).value_or(0.0);
  weather.wind_G = draws.vector("weather/wind", entries.wind).value_or(weather.wind_G);
  const auto colour = draws.vector("weather/colour", entries.colour);
  if (colour) weather.colour = colour->cast<float>();
  return weather;
}

render::SensorEffects SceneVariation::varied(const render::SensorEffects& effects,
                                             randomize::EntryDraws& draws) const {
  const randomize::SensorRandomization& sensor = config_.sensor;
  render::SensorEffects result = effects;
  result.exposure = draws.number("sensor/exposure", sensor.exposure).value_or(effects.exposure);
  result.blur = draws.number("sensor/blur", sensor.blur).value_or(effects.blur);
  result.noise_stddev =
      draws.number("sensor/noise_stddev", sensor.noise_stddev).value_or(effects.noise_stddev);
  result.white_balance =
      draws.number("sensor/white_balance", sensor.white_balance).value_or(effects.white_balance);
  if (const auto quality = draws.number("sensor/jpeg_quality", sensor.jpeg_quality)) {
    result.jpeg_quality = static_cast<int>(std::lround(*quality));
  }
  return result;
}

std::vector<base::DrawFacts> SceneVariation::draws(std::size_t camera) const {
  std::vector<base::DrawFacts> facts;
  for (const auto* values : {&chosen_, &shared_, &cameras_[camera]}) {
    for (const randomize::DrawnValue& drawn : *values) {
      facts.push_back({drawn.name, base::jsonText(valueOf(drawn))});
    }
  }
  return facts;
}

}  // namespace synthetic_dataset::scene

#include "scene_variation.h"

#include <algorithm>
#include <string>
#include <variant>

#include "config/settings_text.h"
#include "error_collector.h"
#include "field_of_view.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset {
namespace {

const char* const kOthers = "every";
const char* const kFieldOfView = "randomize/sensor/field_of_view";

Value valueOf(const appearance::DrawnValue& drawn) {
  if (const auto* text = std::get_if<std::string>(&drawn.value)) return Value(*text);
  const auto& numbers = std::get<std::vector<double>>(drawn.value);
  if (numbers.size() == 1) return Value(numbers.front());
  return Value(Value::List(numbers.begin(), numbers.end()));
}

}  // namespace

SceneVariation::SceneVariation(const config::Config& config, const std::vector<CameraRig>& cameras,
                               const world::World& world)
    : config_(config.randomization),
      seed_(static_cast<std::uint64_t>(config.seed)),
      cameras_(cameras.size()) {
  for (const CameraRig& camera : cameras) {
    effects_.push_back(camera.effects);
    models_.push_back(camera.model);
  }
  ErrorCollector errors;
  static_cast<void>(errors.attempt([&] {
    const auto& field_of_view = config_.sensor.field_of_view;
    if (!field_of_view) return true;
    checkFieldOfView(*field_of_view, kFieldOfView, cameras);
    notes_ = fieldOfViewNotes(*field_of_view, kFieldOfView, cameras);
    return true;
  }));
  static_cast<void>(errors.attempt([&] {
    if (config_.changesLook()) looks_.emplace(config_, world);
    return true;
  }));
  std::vector<std::string> names;
  for (const config::ObjectConfig& object : config.objects) {
    if (object.is_distractor) continue;
    names.push_back(object.name);
    takes_part_.push_back(object.takes_part);
    auto entry = config_.present.find(object.name);
    if (entry == config_.present.end()) entry = config_.present.find(kOthers);
    present_.emplace_back("objects/" + object.name + "/present", std::nullopt);
    if (entry != config_.present.end()) present_.back().second = entry->second;
  }
  for (const auto& [name, share] : config_.present) {
    if (name == kOthers || std::find(names.begin(), names.end(), name) != names.end()) continue;
    errors.add("randomize/objects/" + name + ": robot_list has no object of this name" +
               didYouMean(name, names));
  }
  errors.throwIfAny();
}

void SceneVariation::choose(std::int64_t instant, world::World& world) {
  appearance::EntryDraws draws(seed_, instant);
  std::vector<bool> present = takes_part_;
  for (std::size_t i = 0; i < present.size(); ++i) {
    const auto& [name, share] = present_[i];
    if (present[i] && share) present[i] = draws.happens(name, *share);
  }
  world.setPresent(present);
  chosen_ = draws.values();
}

void SceneVariation::vary(std::int64_t instant, render::Renderer& renderer,
                          std::vector<CameraRig>& cameras) {
  if (looks_) {
    appearance::EntryDraws draws(seed_, instant);
    renderer.setLook(looks_->sample(draws));
    shared_ = draws.values();
  }
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    appearance::EntryDraws draws(seed_, instant, cameras[i].name);
    cameras[i].effects = varied(effects_[i], draws);
    const auto angle = draws.number("sensor/field_of_view", config_.sensor.field_of_view);
    if (angle) cameras[i].model = withFieldOfView(models_[i], *angle);
    cameras_[i] = draws.values();
  }
}

sensor::SensorEffects SceneVariation::varied(const sensor::SensorEffects& effects,
                                             appearance::EntryDraws& draws) const {
  const config::SensorRandomization& sensor = config_.sensor;
  sensor::SensorEffects result = effects;
  result.exposure = draws.number("sensor/exposure", sensor.exposure).value_or(effects.exposure);
  result.blur = draws.number("sensor/blur", sensor.blur).value_or(effects.blur);
  result.noise_stddev =
      draws.number("sensor/noise_stddev", sensor.noise_stddev).value_or(effects.noise_stddev);
  return result;
}

std::vector<output::DrawFacts> SceneVariation::draws(std::size_t camera) const {
  std::vector<output::DrawFacts> facts;
  for (const auto* values : {&chosen_, &shared_, &cameras_[camera]}) {
    for (const appearance::DrawnValue& drawn : *values) {
      facts.push_back({drawn.name, config::jsonText(valueOf(drawn))});
    }
  }
  return facts;
}

}  // namespace synthetic_dataset

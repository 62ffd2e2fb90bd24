#include "run/setup/transfer_preset.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "base/yaml_value.h"
#include "config/config.h"
#include "config/settings_file.h"
#include "run/setup/model_colours.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

using config::groupIn;

/// What suits everything: no pose and no camera changes.
const char* const kLook = R"(
rendering: {light: full}
randomize:
  variety: same_object
  lights:
    every:
      present: 0.9
      intensity: {log_uniform: [0.6, 1.8]}
      # Black bodies of 3000, 4000, 5000, 6500 and 9000 K, of equal brightness: linear.
      colour: {choice: [[1.45, 0.93, 0.42], [1.22, 0.97, 0.67], [1.09, 0.98, 0.85], [0.99, 1.0, 1.03], [0.87, 1.02, 1.27]], weights: [1, 1, 2, 3, 1]}
      elevation: {uniform: [0.2, 1.5]}
      azimuth: {uniform: [-3.14159, 3.14159]}
      shift: {normal: [0.0, 0.15]}
  ambient: {uniform: [0.4, 0.85]}
  background: {pictures: natural, brightness: {uniform: [0.8, 1.3]}}
  materials:
    objects: {for_each: model, tint: {uniform: [[0.88, 0.84, 0.84], [1.0, 1.0, 1.0]]}}
  sensor:
    exposure: {normal: [0.1, 0.35], min: -0.7, max: 0.8}
    blur: {uniform: [0.0, 1.0]}
    noise_stddev: {uniform: [0.0, 0.025]}
)";

/// What the settings' own world gets.
const char* const kOwnWorld = R"(
randomize: {materials: {world: {tint: {uniform: [0.5, 1.0]}, roughness: {uniform: [0.35, 1.0]}}}}
)";

/// What objects that have no surroundings get. Lengths are in sizes of the largest object, but for
/// those of the air.
const char* const kSurroundings = R"(
labels: {min_visibility: 0.15, min_pixels: 30}
world: {file: "package://synthetic_dataset/worlds/sun.sdf"}
camera:
  sample:
    look_at: any
    unit: sizes
    distance: {log_uniform: [1.6, 18.0]}
    elevation: {uniform: [0.0, 0.8]}
    aim_offset: {normal: [0.0, 0.12]}
    roll: {normal: [0.0, 0.08]}
randomize:
  sensor: {field_of_view: {uniform: [0.5, 1.3]}}
motions:
  - name: pasted
    weight: 1.0
    placement: {mode: volume, orientation: upright, volume: {min: [-3.5, -3.5, 0.0], max: [3.5, 3.5, 0.9]}}
    randomize:
      distractors:
        count: {uniform: [0, 8]}
        pool: 60
        size: {log_uniform: [0.14, 1.1]}
        textures: natural
        volume: {min: [-4.3, -4.3, -0.7], max: [4.3, 4.3, 2.1]}
  - name: fallen
    weight: 0.4
    placement: {mode: volume, orientation: random, volume: {min: [-3.0, -3.0, 0.0], max: [3.0, 3.0, 1.1]}}
    camera: {sample: {elevation: {uniform: [0.1, 1.5]}}}
    randomize:
      distractors:
        count: {uniform: [0, 8]}
        pool: 60
        size: {log_uniform: [0.14, 1.1]}
        textures: natural
        volume: {min: [-4.3, -4.3, -0.7], max: [4.3, 4.3, 2.1]}
  - name: open_ground
    weight: 1.0
    placement: {mode: drop, orientation: upright, volume: {min: [-4.0, -4.0, 0.05], max: [4.0, 4.0, 0.3]}}
    camera: {sample: {elevation: {uniform: [0.03, 0.8]}}}
    randomize:
      room: {size: [150.0, 150.0, 0.0], tile: 4.0}
      weather: {present: 0.15, visibility: {log_uniform: [40, 400]}, rain: {log_uniform: [1, 20]}}
      materials: {room: {textures: natural, tint: {uniform: [0.6, 1.0]}, roughness: {uniform: [0.35, 1.0]}}}
      distractors:
        count: {uniform: [0, 8]}
        pool: 60
        mode: stand
        size: {log_uniform: [0.2, 3.0]}
        textures: natural
        volume: {min: [-9.0, -9.0, 0.0], max: [9.0, 9.0, 4.0]}
  - name: room
    weight: 0.7
    placement: {mode: drop, orientation: upright, volume: {min: [-3.5, -3.5, 0.05], max: [3.5, 3.5, 0.3]}}
    camera: {sample: {distance: {log_uniform: [1.6, 8.0]}}}
    randomize:
      room: {size: [11.0, 11.0, 4.5], tile: 3.0}
      materials: {room: {textures: natural, tint: {uniform: [0.6, 1.0]}, roughness: {uniform: [0.35, 1.0]}}}
      distractors:
        count: {uniform: [0, 8]}
        pool: 60
        mode: stand
        size: {log_uniform: [0.15, 1.6]}
        textures: natural
        volume: {min: [-5.0, -5.0, 0.0], max: [5.0, 5.0, 3.0]}
)";

Value::Map parsed(const char* text) {
  return config::asParameters(base::parseYaml(text, "the preset"), "the preset");
}

bool has(const Value::Map& settings, const std::string& name) { return settings.count(name) != 0; }

const Value* entryIn(const Value::Map& settings, const std::string& group,
                     const std::string& name) {
  const Value::Map* map = groupIn(settings, group);
  if (map == nullptr || map->count(name) == 0) return nullptr;
  return &map->at(name);
}

/// Multiplies every number below a value.
void multiply(Value& value, double factor) {
  if (auto* map = value.as<Value::Map>()) {
    for (auto& [name, entry] : *map) multiply(entry, factor);
  } else if (auto* list = value.as<Value::List>()) {
    for (Value& entry : *list) multiply(entry, factor);
  } else if (const auto* number = value.as<double>()) {
    value = Value(*number * factor);
  } else if (const auto* whole = value.as<std::int64_t>()) {
    value = Value(static_cast<double>(*whole) * factor);
  }
}

/// From sizes of the largest object to metres.
void scaleLengths(Value& value, double size) {
  static const std::set<std::string> kLengths = {"volume", "size", "tile"};
  if (auto* list = value.as<Value::List>()) {
    for (Value& entry : *list) scaleLengths(entry, size);
  }
  auto* map = value.as<Value::Map>();
  if (map == nullptr) return;
  for (auto& [name, entry] : *map) {
    if (kLengths.count(name) != 0) {
      multiply(entry, size);
    } else {
      scaleLengths(entry, size);
    }
  }
}

/// The diagonal of the box around what is seen of a model, along its axes [m].
double sizeOf(const world::Model& model) {
  Eigen::AlignedBox3d box;
  for (const world::Link& link : model.links) {
    for (const world::Visual& visual : link.visuals) {
      const Pose X_MV = link.X_ML * visual.X_LV;
      for (const world::Surface& surface : visual.surfaces) {
        for (const Eigen::Vector3f& p : surface.mesh->positions) {
          box.extend(X_MV * p.cast<double>());
        }
      }
    }
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// What of the objects the surroundings follow.
struct ObjectLook {
  double size = 1.0;    ///< of the largest [m]
  Value::List colours;  ///< that stand out, as settings have them
};

/// Of all objects whose models can be read; what is wrong with others is said when they are loaded.
ObjectLook lookOfObjects(const config::Config& config, InputCache& inputs) {
  WorldFiles& files = inputs.worlds.filesFor(config.world);
  ObjectLook look;
  double largest = 0.0;
  for (const scene::ObjectOptions& object : config.objects) {
    if (!object.model) continue;
    try {
      const world::Model& model = files.model(*object.model, object.name, object.model_arguments);
      largest = std::max(largest, sizeOf(model));
      for (const Eigen::Vector3d& each : strikingColours(model)) {
        const Value colour(Value::List{each.x(), each.y(), each.z()});
        const bool is_new =
            std::find(look.colours.begin(), look.colours.end(), colour) == look.colours.end();
        if (is_new) look.colours.push_back(colour);
      }
    } catch (const Error&) {
      continue;
    }
  }
  if (largest > 0.0) look.size = largest;
  return look;
}

/// Distractors in the objects' own colours: colour alone does not tell an object.
void paintDistractors(Value::Map& settings, const Value::List& colours) {
  for (Value& entry : *settings.at("motions").as<Value::List>()) {
    Value::Map& randomize = *groupIn(*entry.as<Value::Map>(), "randomize");
    if (!colours.empty()) (*groupIn(randomize, "distractors"))["colours"] = Value(colours);
  }
}

/// So that one picture in eight has no object, and about half of several objects are there.
double presenceOf(std::size_t objects) {
  constexpr double kEmpty = 0.12;
  return std::max(0.5, 1.0 - std::pow(kEmpty, 1.0 / static_cast<double>(objects)));
}

/// What the settings say themselves counts over what the preset's motions say.
void overlayMotions(Value::Map& preset, const Value::Map& own) {
  for (Value& entry : *preset.at("motions").as<Value::List>()) {
    Value::Map& motion = *entry.as<Value::Map>();
    Value::Map over;
    for (const char* name : {"camera", "randomize"}) {
      if (has(own, name)) over[name] = own.at(name);
    }
    config::overlay(motion, over);
  }
}

/// A camera that is put somewhere is not drawn.
bool hasPlace(const Value::Map& settings) {
  return has(settings, "cameras") || has(settings, "camera_frame_id") ||
         entryIn(settings, "camera", "pose") != nullptr ||
         entryIn(settings, "camera", "mounted_on") != nullptr ||
         entryIn(settings, "camera", "sensor") != nullptr;
}

void leaveCameraOut(Value::Map& settings) {
  settings.erase("camera");
  for (Value& entry : *settings.at("motions").as<Value::List>()) {
    entry.as<Value::Map>()->erase("camera");
  }
}

/// Why the settings keep their own surroundings; empty: they have none.
std::string ownSurroundings(const Value::Map& settings) {
  const auto motion = settings.find("motion");
  if (motion == settings.end() || motion->second != Value("placement")) return "a recording";
  if (has(settings, "motions")) return "motions of their own";
  if (has(settings, "placement")) return "a placement of their own";
  const bool names_world = has(settings, "world_file") ||
                           entryIn(settings, "world", "file") != nullptr ||
                           (has(settings, "world") && !settings.at("world").is<Value::Map>());
  return names_world ? "a world of their own" : "";
}

}  // namespace

ExpandedPreset expandPreset(const Value& settings, InputCache& inputs) {
  const auto* given = settings.as<Value::Map>();
  const Value* preset = given == nullptr ? nullptr : entryIn(*given, "randomize", "preset");
  if (preset == nullptr || *preset != Value("transfer")) return {settings, {}};
  Value::Map own = *given;
  groupIn(own, "randomize")->erase("preset");
  Value::Map expanded = parsed(kLook);
  const std::string surroundings = ownSurroundings(own);
  if (!surroundings.empty()) {
    config::overlay(expanded, parsed(kOwnWorld));
    config::overlay(expanded, own);
    return {Value(std::move(expanded)),
            {"the settings have " + surroundings +
             ", so that poses and cameras stay as they are: the preset changes light, paint, "
             "background and sensor alone"}};
  }
  Value::Map around = parsed(kSurroundings);
  config::overlay(expanded, around);
  if (hasPlace(own)) leaveCameraOut(expanded);
  Value::Map measured = expanded;
  measured.erase("motions");
  config::overlay(measured, own);
  const config::Config config = config::readConfig(Parameters(Value(measured)));
  const ObjectLook look = lookOfObjects(config, inputs);
  scaleLengths(expanded.at("motions"), look.size);
  paintDistractors(expanded, look.colours);
  const std::size_t objects = std::max<std::size_t>(config.robotCount(), 1);
  config::overlay(
      expanded,
      {{"randomize",
        Value::Map{
            {"objects", Value::Map{{"every", Value::Map{{"present", presenceOf(objects)}}}}}}}});
  overlayMotions(expanded, own);
  config::overlay(expanded, own);
  return {Value(std::move(expanded)), {}};
}

}  // namespace synthetic_dataset::run

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
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

using config::groupIn;

/// What suits everything: no pose and no camera changes.
const char* const kLook = R"(
randomize:
  variety: same_object
  lights:
    every:
      present: 0.9
      intensity: {log_uniform: [0.8, 2.0]}
      # Black bodies of 3000, 4000, 5000, 6500 and 9000 K, of equal brightness: linear.
      colour: {choice: [[1.45, 0.93, 0.42], [1.22, 0.97, 0.67], [1.09, 0.98, 0.85], [0.99, 1.0, 1.03], [0.87, 1.02, 1.27]], weights: [1, 1, 2, 3, 1]}
      elevation: {uniform: [0.2, 1.5]}
      azimuth: {uniform: [-3.14159, 3.14159]}
      shift: {normal: [0.0, 0.15]}
  ambient: {uniform: [0.55, 0.95]}
  background: {pictures: natural, brightness: {uniform: [0.8, 1.3]}}
  materials:
    objects: {for_each: model, tint: {uniform: [[0.88, 0.84, 0.84], [1.0, 1.0, 1.0]]}}
  sensor:
    exposure: {normal: [0.15, 0.3], min: -0.5, max: 0.8}
    blur: {uniform: [0.0, 1.0]}
    noise_stddev: {uniform: [0.0, 0.025]}
)";

/// What the settings' own world gets.
const char* const kOwnWorld = R"(
randomize:
  materials: {world: {textures: natural, tint: {uniform: [0.7, 1.0]}, roughness: {uniform: [0.35, 1.0]}}}
  distractors: {count: {uniform: [0, 8]}, pool: 60, mode: stand, size: {log_uniform: [0.08, 0.8]}, textures: natural}
)";

/// What objects that have no surroundings get. Lengths are in sizes of the largest object, but for
/// those of the air.
const char* const kSurroundings = R"(
labels: {min_visibility: 0.15, min_pixels: 16}
world: {file: "package://synthetic_dataset/worlds/sun.sdf"}
camera:
  sample:
    look_at: any
    unit: sizes
    distance: {log_uniform: [1.1, 18.0]}
    elevation: {uniform: [0.0, 0.8]}
    aim_offset: {normal: [0.0, 0.12]}
    roll: {normal: [0.0, 0.08]}
randomize:
  sensor: {field_of_view: {uniform: [0.5, 1.3]}}
  distractors: {count: {uniform: [0, 8]}, pool: 60, textures: natural}
motions:
  - name: pasted
    weight: 1.0
    placement: {mode: volume, orientation: upright, rows: 0.3, volume: {min: [-2.6, -2.6, 0.0], max: [2.6, 2.6, 0.9]}}
    randomize:
      distractors: &flying {size: {log_uniform: [0.14, 1.1]}, volume: {min: [-4.3, -4.3, -0.7], max: [4.3, 4.3, 2.1]}}
  - name: fallen
    weight: 0.4
    placement: {mode: volume, orientation: random, volume: {min: [-2.3, -2.3, 0.0], max: [2.3, 2.3, 1.1]}}
    camera: {sample: {elevation: {uniform: [0.1, 1.5]}}}
    randomize:
      distractors: *flying
  - name: open_ground
    weight: 1.0
    placement: {mode: drop, orientation: upright, rows: 0.3, volume: {min: [-3.0, -3.0, 0.05], max: [3.0, 3.0, 0.3]}}
    camera: {sample: {elevation: {uniform: [0.03, 0.8]}}}
    randomize:
      room: &ground {size: [150.0, 150.0, 0.0], tile: 4.0}
      materials: &paint {room: {textures: natural, tint: {uniform: [0.7, 1.0]}, roughness: {uniform: [0.35, 1.0]}}}
      weather: {present: 0.15, visibility: {log_uniform: [40, 400]}, rain: {log_uniform: [1, 20]}}
      distractors: &standing {mode: stand, size: {log_uniform: [0.2, 3.0]}, volume: {min: [-9.0, -9.0, 0.0], max: [9.0, 9.0, 4.0]}}
  - name: row
    weight: 0.5
    placement: {mode: drop, orientation: upright, rows: 1.0, volume: {min: [-9.0, -9.0, 0.05], max: [9.0, 9.0, 0.3]}}
    camera: {sample: {elevation: {uniform: [0.03, 0.6]}}}
    randomize:
      room: *ground
      materials: *paint
      distractors: *standing
  - name: room
    weight: 0.7
    placement: {mode: drop, orientation: upright, rows: 0.3, volume: {min: [-2.8, -2.8, 0.05], max: [2.8, 2.8, 0.3]}}
    camera: {sample: {distance: {log_uniform: [1.1, 8.0]}}}
    randomize:
      room: {size: [11.0, 11.0, 4.5], tile: 3.0}
      materials: *paint
      distractors: {mode: stand, size: {log_uniform: [0.15, 1.6]}, volume: {min: [-5.0, -5.0, 0.0], max: [5.0, 5.0, 3.0]}}
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

/// A row has at least three objects, or all of fewer: no row.
void fillRows(Value::Map& settings, std::size_t objects) {
  constexpr std::size_t kFewest = 3;
  Value::List& motions = *settings.at("motions").as<Value::List>();
  const auto row = std::find_if(motions.begin(), motions.end(), [](const Value& motion) {
    return motion.as<Value::Map>()->at("name") == Value("row");
  });
  if (objects < kFewest) {
    motions.erase(row);
    return;
  }
  Value::List counts;
  for (std::size_t k = kFewest; k <= objects; ++k) {
    counts.emplace_back(static_cast<std::int64_t>(k));
  }
  (*groupIn(*row->as<Value::Map>(), "randomize"))["object_count"] =
      Value(Value::Map{{"choice", Value(counts)}});
}

/// Makes room for many objects.
void widenPlacements(Value::Map& settings, std::size_t objects) {
  constexpr double kFew = 10.0;  // have room in the preset's volumes
  const double factor = std::sqrt(static_cast<double>(objects) / kFew);
  if (factor <= 1.0) return;
  for (Value& entry : *settings.at("motions").as<Value::List>()) {
    Value::Map& volume = *groupIn(*groupIn(*entry.as<Value::Map>(), "placement"), "volume");
    for (const char* corner : {"min", "max"}) {
      Value::List& place = *volume.at(corner).as<Value::List>();
      for (std::size_t axis = 0; axis < 2; ++axis) multiply(place[axis], factor);
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

const world::Model& modelOf(const scene::ObjectOptions& object, WorldFiles& files) {
  if (object.model) return files.model(*object.model, object.name, object.model_arguments);
  const std::vector<world::Model>& models = files.world().models;
  const auto found = std::find_if(models.begin(), models.end(), [&](const world::Model& model) {
    return model.name == object.name;
  });
  if (found == models.end()) throw Error("the world has no model '" + object.name + "'");
  return *found;
}

/// Of the largest object [m], where some move: of those; what is wrong with models is said when
/// they are loaded.
double largestSize(const config::Config& config, InputCache& inputs) {
  WorldFiles& files = inputs.worlds.filesFor(config.world);
  double largest = 0.0;
  const bool some_move = std::any_of(config.objects.begin(), config.objects.end(),
                                     [](const auto& object) { return !object.stands; });
  for (const scene::ObjectOptions& object : config.objects) {
    if (some_move && object.stands) continue;
    try {
      largest = std::max(largest, sizeOf(modelOf(object, files)));
    } catch (const Error&) {
      continue;
    }
  }
  return largest > 0.0 ? largest : 1.0;
}

/// How many objects there are in a scene: none in one of five, and few more often than many, as
/// things are met.
Value countOf(std::size_t objects) {
  constexpr double kEmpty = 0.2;
  double sum = 0.0;
  for (std::size_t k = 1; k <= objects; ++k) sum += 1.0 / static_cast<double>(k);
  Value::List counts{std::int64_t{0}};
  Value::List weights{kEmpty};
  for (std::size_t k = 1; k <= objects; ++k) {
    counts.emplace_back(static_cast<std::int64_t>(k));
    weights.emplace_back((1.0 - kEmpty) / sum / static_cast<double>(k));
  }
  return Value(Value::Map{{"choice", Value(counts)}, {"weights", Value(weights)}});
}

/// Whether the settings say themselves which objects are there.
bool saysWhatIsPresent(const Value::Map& settings) {
  const Value* objects = entryIn(settings, "randomize", "objects");
  const auto* entries = objects == nullptr ? nullptr : objects->as<Value::Map>();
  if (entries == nullptr) return false;
  return std::any_of(entries->begin(), entries->end(), [](const auto& entry) {
    const auto* object = entry.second.template as<Value::Map>();
    return object != nullptr && has(*object, "present");
  });
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
  if (!has(settings, "motions")) return;
  for (Value& entry : *settings.at("motions").as<Value::List>()) {
    entry.as<Value::Map>()->erase("camera");
  }
}

bool isPlaced(const Value::Map& settings) {
  const auto motion = settings.find("motion");
  return motion != settings.end() && motion->second == Value("placement");
}

/// Whether a camera has pictures of the recording; they show what was there.
bool hasRecordedPictures(const Value::Map& settings) {
  if (entryIn(settings, "camera", "image_topic") != nullptr) return true;
  if (const Value::Map* cameras = groupIn(settings, "cameras")) {
    for (const auto& [name, camera] : *cameras) {
      const auto* group = camera.as<Value::Map>();
      if (group != nullptr && has(*group, "image_topic")) return true;
    }
  }
  const auto motions = settings.find("motions");
  const auto* list = motions == settings.end() ? nullptr : motions->second.as<Value::List>();
  return list != nullptr && std::any_of(list->begin(), list->end(), [](const Value& motion) {
           const auto* own = motion.as<Value::Map>();
           return own != nullptr && hasRecordedPictures(*own);
         });
}

/// Why the settings keep their own surroundings; empty: they have none.
std::string ownSurroundings(const Value::Map& settings) {
  if (!isPlaced(settings)) return "a recording";
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
  const std::string surroundings = ownSurroundings(own);
  Value::Map expanded = parsed(kLook);
  config::overlay(expanded, parsed(surroundings.empty() ? kSurroundings : kOwnWorld));
  if (hasPlace(own)) leaveCameraOut(expanded);
  Value::Map measured = expanded;
  measured.erase("motions");
  config::overlay(measured, own);
  measured.erase("randomize");
  const config::Config config = config::readConfig(Parameters(Value(measured)));
  const double size = largestSize(config, inputs);
  const auto placed = std::count_if(
      config.objects.begin(), config.objects.end(),
      [](const scene::ObjectOptions& object) { return !object.stands && !object.is_distractor; });
  const std::size_t objects = std::max<std::size_t>(static_cast<std::size_t>(placed), 1);
  Value::Map& randomize = *groupIn(expanded, "randomize");
  const bool counts = isPlaced(own) && !saysWhatIsPresent(own);
  if (counts) randomize["object_count"] = countOf(objects);
  ExpandedPreset result;
  if (surroundings.empty()) {
    scaleLengths(expanded.at("motions"), size);
    widenPlacements(expanded, objects);
    if (counts) fillRows(expanded, objects);
    overlayMotions(expanded, own);
  } else {
    scaleLengths(expanded.at("randomize"), size);
    const bool has_pictures = hasRecordedPictures(own);
    if (has_pictures) randomize.erase("distractors");
    result.notes.push_back(
        "the settings have " + surroundings +
        ", so that poses and cameras stay as they are: the preset changes light, paint, "
        "background" +
        (has_pictures ? "" : ", distractors") + " and sensor alone");
  }
  config::overlay(expanded, own);
  result.settings = Value(std::move(expanded));
  return result;
}

}  // namespace synthetic_dataset::run

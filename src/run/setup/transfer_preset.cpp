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
#include "run/pictures/model_portrait.h"
#include "run/setup/transfer_preset_text.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

using config::groupIn;

bool has(const Value::Map& settings, const std::string& name) { return settings.count(name) != 0; }

const Value* entryIn(const Value::Map& settings, const std::string& group,
                     const std::string& name) {
  const Value::Map* map = groupIn(settings, group);
  if (map == nullptr || map->count(name) == 0) return nullptr;
  return &map->at(name);
}

/// Multiplies every number in a tree of values.
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

/// Converts lengths from multiples of the largest object's size to metres.
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

/// Sets the number of objects in a row, at least three; with fewer objects there is no row.
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

/// Enlarges the volumes for many objects.
void widenPlacements(Value::Map& settings, std::size_t objects) {
  constexpr double kFew = 10.0;  // fit into the preset's volumes
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

const world::Model& modelOf(const scene::ObjectOptions& object, WorldFiles& files) {
  if (object.model) return files.model(*object.model, object.name, object.model_arguments);
  const std::vector<world::Model>& models = files.world().models;
  const auto found = std::find_if(models.begin(), models.end(), [&](const world::Model& model) {
    return model.name == object.name;
  });
  if (found == models.end()) throw Error("the world has no model '" + object.name + "'");
  return *found;
}

/// The diagonal of the visible bounds of the largest object [m], considering only moving ones if
/// there are any. Errors in models are reported when the run loads them.
double largestSize(const config::Config& config, InputCache& inputs) {
  WorldFiles& files = inputs.worlds.filesFor(config.world);
  double largest = 0.0;
  const bool some_move = std::any_of(config.objects.begin(), config.objects.end(),
                                     [](const auto& object) { return !object.stands; });
  for (const scene::ObjectOptions& object : config.objects) {
    if (some_move && object.stands) continue;
    try {
      const Eigen::AlignedBox3d box_M = visibleBounds(modelOf(object, files), Pose::Identity());
      if (!box_M.isEmpty()) largest = std::max(largest, box_M.diagonal().norm());
    } catch (const Error&) {
      continue;
    }
  }
  return largest > 0.0 ? largest : 1.0;
}

/// The number of objects in a scene: none in one scene of five, and few more often than many, as in
/// real scenes.
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

/// Whether the settings specify which objects are present.
bool saysWhatIsPresent(const Value::Map& settings) {
  const Value* objects = entryIn(settings, "randomize", "objects");
  const auto* entries = objects == nullptr ? nullptr : objects->as<Value::Map>();
  if (entries == nullptr) return false;
  return std::any_of(entries->begin(), entries->end(), [](const auto& entry) {
    const auto* object = entry.second.template as<Value::Map>();
    return object != nullptr && has(*object, "present");
  });
}

/// Lets the settings' own entries override those of the preset's motions.
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

/// Whether the camera has a fixed place, which is then not randomized.
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

/// Whether a camera uses recorded pictures, which show the real surroundings.
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

/// Why the settings keep their own surroundings; empty if they have none.
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
  const Value::Map parts =
      config::asParameters(base::parseYaml(kTransferPreset, "the preset"), "the preset");
  Value::Map expanded = *groupIn(parts, "look");
  config::overlay(expanded, *groupIn(parts, surroundings.empty() ? "surroundings" : "own_world"));
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
        ", so that poses and cameras stay as they are: the preset only changes light, "
        "paint, background" +
        (has_pictures ? "" : ", distractors") + " and sensor");
  }
  config::overlay(expanded, own);
  result.settings = Value(std::move(expanded));
  return result;
}

}  // namespace synthetic_dataset::run

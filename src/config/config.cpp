#include "config/config.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/seconds.h"
#include "config/checked_values.h"
#include "config/readers.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

/// Checks that scenes keep their order, as physics only moves forward.
void checkJitter(Parameters& root, const motion::MotionOptions& motion,
                 const randomize::Randomization& randomization) {
  if (!randomization.time_jitter) return;
  Parameters group = root.group("randomize").group("time");
  if (motion.source == motion::MotionSource::kPlacement) {
    group.addError("jitter",
                   "has a meaning with motion: bag alone; what is placed at random stands still");
    return;
  }
  constexpr double kRounding = 3e-9;  // [s]; periods and times are whole nanoseconds
  const double earliest = randomization.time_jitter->lowest();
  const double latest = randomization.time_jitter->highest();
  const double period = 1.0 / motion.rate;
  if (latest - earliest <= period - kRounding) return;
  group.addError("jitter", "found " + Value(earliest).text() + " to " + Value(latest).text() +
                               " s; the two should be less than " + Value(period).text() +
                               " s apart, the time from scene to scene (simulated_rate), so that "
                               "scenes keep their order; a normal distribution needs `min` and "
                               "`max`");
}

/// `world` is a file's name, or a group with `file`, `model_folders`, `on_missing_asset` and
/// `simulator`.
WorldConfig readWorld(Parameters& root) {
  WorldConfig world;
  const auto replaced = root.maybe<std::string>("world_file");
  const auto given = root.maybe<Value>("world");
  if (given && given->is<Value::Map>()) {
    Parameters group = root.group("world");
    if (!replaced) world.file = group.required<std::string>("file");
    group.ignore("file");
    world.model_folders =
        group.maybe<std::vector<std::string>>("model_folders").value_or(std::vector<std::string>{});
    for (std::string& folder : world.model_folders) folder = absolutePath(folder);
    world.loading.on_missing_asset = choice<world::OnMissingAsset>(
        group, "on_missing_asset",
        {{"error", world::OnMissingAsset::kError}, {"warn", world::OnMissingAsset::kWarn}});
    world.loading.simulator =
        choice<std::optional<world::Simulator>>(group, "simulator",
                                                {{"auto", std::nullopt},
                                                 {"classic", world::Simulator::kClassic},
                                                 {"gz", world::Simulator::kGz}});
  } else if (given || !replaced) {
    world.file = root.required<std::string>("world");
  }
  if (replaced) world.file = *replaced;
  world.file = pathOrUri(world.file);
  return world;
}

world::PhysicsOptions readPhysics(Parameters group, const scene::SceneOptions& scenes) {
  world::PhysicsOptions physics;
  constexpr double kLongestStep = 0.1;  // [s]; with longer steps, things fall through floors
  double step = numberAbove(group, "step", toSeconds(physics.step), 1e-5);
  if (step > kLongestStep) {
    group.addError("step", "found " + Value(step).text() + " s; it should be at most 0.1");
    step = kLongestStep;
  }
  physics.step = base::fromSeconds(step);
  constexpr double kDeepest = 1.0;  // [m]; anything larger was meant in another unit
  physics.contact_tolerance =
      group.optionalBetween("contact_tolerance", physics.contact_tolerance, 0.0, kDeepest);
  physics.drops_objects =
      scenes.isPlaced() && scenes.placement.mode == randomize::PlacementMode::kDrop;
  const auto& distractors = scenes.randomization.distractors;
  physics.drops_distractors = distractors && distractors->mode == randomize::DistractorMode::kDrop;
  physics.labels_distractors = distractors && distractors->label_class;
  return physics;
}

/// Placed scenes show a world that has come to rest; a recording starts without settling.
Duration readSettling(Parameters& physics, bool is_placed) {
  constexpr double kUntilRest = 10.0;  // [s] at most
  return base::fromSeconds(maybeSeconds(physics, "settle").value_or(is_placed ? kUntilRest : 0.0));
}

render::RenderOptions readRendering(Parameters& root) {
  render::RenderOptions rendering;
  Parameters group = root.group("rendering");
  rendering.light = choice<render::LightDetail>(
      group, "light",
      {{"simple", render::LightDetail::kSimple}, {"full", render::LightDetail::kFull}});
  rendering.samples = group.optional("samples", rendering.samples);
  if (rendering.samples != 1 && rendering.samples != 4) {
    group.addError("samples", "found " + std::to_string(rendering.samples) +
                                  "; it should be 1 or 4, which Mesa supports");
    rendering.samples = 4;
  }
  rendering.shadow_map_size =
      group.optionalBetween("shadow_map_size", rendering.shadow_map_size, 64, 8192);
  rendering.shadow_distance = numberAbove(group, "shadow_distance", rendering.shadow_distance, 0.0);
  rendering.reuse = group.optional("reuse", rendering.reuse);
  Parameters labels = root.group("labels");
  rendering.glass_in_labels =
      choice<render::GlassInLabels>(labels, "glass",
                                    {{"objects", render::GlassInLabels::kOfObjects},
                                     {"solid", render::GlassInLabels::kSolid},
                                     {"clear", render::GlassInLabels::kClear}});
  return rendering;
}

/// Whether a group looks like that of an object or a writer that this run does not use.
bool isUnusedBlock(const Value& value) {
  const auto* map = value.as<Value::Map>();
  if (map == nullptr) return false;
  const auto holds = [&](const char* name) { return map->count(name) != 0; };
  return holds("output_folder") || (holds("class") && holds("id"));
}

/// Checks that objects' indices fit into the 16 bits of an instance map.
void checkObjectCount(Parameters& root, std::size_t count) {
  constexpr std::size_t kMostObjects = 65535;
  if (count <= kMostObjects) return;
  root.addError("robot_list", "found " + std::to_string(count) +
                                  " objects, with the distractors that have a class; it should "
                                  "be at most " +
                                  std::to_string(kMostObjects));
}

}  // namespace

Config readConfig(Parameters root) {
  Config config;
  config.motion = readMotion(root);
  if (config.isPlaced()) config.placement = readPlacement(root);
  config.global_frame = root.optional("global_frame", config.global_frame);
  config.world = readWorld(root);
  config.cameras = readCameras(root);
  config.lidars = readLidars(root, config.cameras);
  config.randomization = readRandomization(root);
  config.twin = readTwinOptions(root, config);
  config.objects = readObjects(root);
  addLabelledDistractors(root, config.randomization.distractors, config.objects);
  checkObjectCount(root, config.objects.size());
  config.classes = readClasses(root, config.objects);
  config.world_classes = readWorldClasses(root, config.classes);
  config.masks = readMasks(root);
  config.labels = readLabels(root);
  config.split = readSplit(root);
  checkJitter(root, config.motion, config.randomization);
  Parameters physics = root.group("physics");
  config.physics = readPhysics(physics, config);
  config.settling = readSettling(physics, config.isPlaced());
  config.rendering = readRendering(root);
  config.seed = root.maybe<std::int64_t>("seed").value_or(config.seed);
  config.output = readOutput(root);
  config.processes = readProcesses(root, config.output.shard.has_value());
  config.only_scenes = readOnlyScenes(root);
  config.writers = readWriters(root, config.output.folder);
  if (config.output.folder.empty()) config.output.folder = commonFolder(config.writers);
  for (const scene::ObjectOptions& object : config.objects) {
    for (const output::WriterOptions& writer : config.writers) {
      if (object.name == writer.name) {
        root.addError("robot_list", "found '" + object.name +
                                        "', which is also a writer's name; rename the writer");
      }
    }
  }
  return config;
}

bool isNnDataCollectionFile(const Value& settings) {
  const auto* map = settings.as<Value::Map>();
  if (map == nullptr || map->count("writers") != 0) return false;
  const std::array<const char*, 3> writers = {"yolo", "stvnet", "bounding_shape"};
  return std::any_of(writers.begin(), writers.end(), [&](const char* name) {
    const auto found = map->find(name);
    if (found == map->end()) return false;
    const auto* group = found->second.as<Value::Map>();
    return group != nullptr && group->count("output_folder") != 0;
  });
}

namespace {

/// "; did you mean camera/effects/blur?" for `blur`, or "" if no group or too many groups have it.
std::string inOtherGroups(const Parameters& root, const std::string& name) {
  constexpr std::size_t kMost = 3;
  const std::vector<std::string> known = root.knownElsewhere(name);
  if (known.empty() || known.size() > kMost) return "";
  std::string choice;
  for (const std::string& each : known) choice += (choice.empty() ? "" : " or ") + each;
  return "; did you mean " + choice + "?";
}

}  // namespace

std::vector<std::string> unknownParameterErrors(Parameters root,
                                                const std::vector<std::string>& names) {
  constexpr std::size_t kMostListed = 100;  // searching for similar names takes time
  // Asking whether a block is unused makes it known, so the suggestions come first.
  std::vector<std::pair<std::string, std::string>> found;
  for (const std::string& name : names) {
    const std::string last = name.substr(name.rfind('/') + 1);
    const bool is_listed = found.size() < kMostListed;
    const std::string near = is_listed ? didYouMean(last, root.knownNeighbours(name)) : "";
    found.emplace_back(name, is_listed && near.empty() ? inOtherGroups(root, last) : near);
  }
  std::vector<std::string> errors;
  std::size_t unlisted = 0;
  for (const auto& [name, suggestion] : found) {
    if (root.has(name) && isUnusedBlock(*root.maybe<Value>(name))) continue;
    if (errors.size() >= kMostListed) {
      ++unlisted;
      continue;
    }
    const bool is_group = root.has(name) && root.maybe<Value>(name)->is<Value::Map>();
    errors.push_back(name + ": unknown parameter" + suggestion +
                     (is_group ? "; nothing in robot_list or writers has this name" : ""));
  }
  if (unlisted > 0) {
    errors.push_back(std::to_string(unlisted) + " more names: unknown parameters, too");
  }
  return errors;
}

}  // namespace synthetic_dataset::config

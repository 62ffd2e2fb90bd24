#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "output/output_options.h"
#include "render/render_options.h"
#include "scene/object_options.h"
#include "scene/scene_options.h"
#include "synthetic_dataset/parameters.h"
#include "world/world_options.h"

/// Every setting of a run as a value, with its default; config/params.yaml documents each.
namespace synthetic_dataset::config {

struct WorldConfig {
  std::string file;
  std::vector<std::string> model_folders;
  world::LoadOptions loading;
};

enum class SplitBy {
  kBlocks,          ///< the first scenes, those after them, the last
  kScenes,          ///< drawn at random
  kBalancedBlocks,  ///< those of a recording that have labels of each class, as far as there are
};

struct SplitConfig {
  std::vector<std::pair<std::string, double>> shares;  ///< name, share > 0; empty: no splits
  SplitBy by = SplitBy::kBlocks;
  double gap = 0.0;  ///< of a recording, left out between blocks [s]
};

struct ClassConfig {
  int id = 0;
  std::string name;
};

/// All settings that hold for a motion, and for the dataset that it is part of.
struct Config : scene::SceneOptions {
  WorldConfig world;
  std::vector<ClassConfig> classes;  ///< in the order of their numbers
  scene::WorldClasses world_classes;
  SplitConfig split;
  world::PhysicsOptions physics;
  render::RenderOptions rendering;
  output::StoreOptions output;
  int processes = 1;                   ///< that make the scenes; 1 where there is a shard
  std::set<std::int64_t> only_scenes;  ///< by the numbers in their files' names; empty: all
  std::vector<output::WriterOptions> writers;
};

/// Reads all settings. What is wrong is noted in `root`, with a harmless value in its place.
[[nodiscard]] Config readConfig(Parameters root);

/// Whether settings are a parameter file of nn_data_collection, perhaps with what it needs here:
/// they have its writers' groups, and no `writers`. What it has besides was never read, and no
/// error there.
[[nodiscard]] bool hasOldForm(const Value& settings);

/// One error for each parameter that nobody reads, with the name that it may have meant. Ask when
/// the writers have read theirs. Blocks of objects and writers that this run does not use are no
/// error: the original's users keep them in their files.
/// @param names  which of the root's unknownNames() are reported
[[nodiscard]] std::vector<std::string> unknownParameterErrors(
    Parameters root, const std::vector<std::string>& names);

}  // namespace synthetic_dataset::config

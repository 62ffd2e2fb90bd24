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
  kScenes,          ///< assigned at random
  kBalancedBlocks,  ///< blocks of a recording such that each split has each class, if possible
};

struct SplitConfig {
  std::vector<std::pair<std::string, double>> shares;  ///< name, share > 0; empty: no splits
  SplitBy by = SplitBy::kBlocks;
  double gap = 0.0;  ///< time of a recording left out between blocks [s]
};

struct ClassConfig {
  int id = 0;
  std::string name;
};

/// All settings that apply to a motion, and to the dataset that it is part of.
struct Config : scene::SceneOptions {
  WorldConfig world;
  std::vector<ClassConfig> classes;  ///< in the order of their numbers
  scene::WorldClasses world_classes;
  SplitConfig split;
  world::PhysicsOptions physics;
  render::RenderOptions rendering;
  output::StoreOptions output;
  int processes = 1;                   ///< number of processes that make scenes; 1 for a shard
  std::set<std::int64_t> only_scenes;  ///< by the numbers in file names; empty: all
  std::vector<output::WriterOptions> writers;
};

/// Reads all settings. Errors are noted in `root`, and a harmless value is used instead.
[[nodiscard]] Config readConfig(Parameters root);

/// Whether settings are a parameter file of nn_data_collection, possibly with additions for this
/// software: they have groups of its writers, and no `writers`. nn_data_collection ignored other
/// settings in such a file, so they are not errors.
[[nodiscard]] bool isNnDataCollectionFile(const Value& settings);

/// One error for each parameter that nothing reads, with the name that may have been meant. Call it
/// after the writers have read theirs. Groups of objects and writers that this run does not use are
/// not errors: users of nn_data_collection keep them in their files.
/// @param names  which of the root's unknownNames() are reported
[[nodiscard]] std::vector<std::string> unknownParameterErrors(
    Parameters root, const std::vector<std::string>& names);

}  // namespace synthetic_dataset::config

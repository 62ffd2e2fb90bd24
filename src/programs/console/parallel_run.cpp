#include "programs/console/parallel_run.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "config/motion_list.h"
#include "config/settings_file.h"
#include "output/files/file_name_rules.h"
#include "output/manifest/manifest_content.h"
#include "programs/console/processes.h"
#include "run/generator.h"
#include "run/merger.h"
#include "run/open_output.h"

namespace synthetic_dataset::programs {
namespace {

/// Sets how many threads Mesa uses if processes share the cores. With none, the calling thread
/// draws, which is best if each process has one core.
void shareCores(int processes) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency()) / processes;
  setenv("LP_NUM_THREADS", std::to_string(cores > 1 ? cores : 0).c_str(), 0);  // keeps the user's
}

/// @return whether all its scenes are made
bool makeShard(const Value::Map& settings, run::Reporter& reporter) {
  run::Generator generator{Value(settings), reporter};
  return !generator.run().stopped;
}

config::Config configOf(const Value::Map& settings) {
  const config::MotionList motions = config::readMotions(Value(settings));
  return config::readConfig(Parameters(motions.entries.front().settings));
}

}  // namespace

ParallelRun::ParallelRun(const Value& settings)
    : settings_(*settings.as<Value::Map>()), config_(configOf(settings_)) {}

bool ParallelRun::isPossible() const {
  if (config_.processes == 1 || !config_.only_scenes.empty()) return false;
  if (config_.output.if_exists == output::IfExists::kOverwrite) return true;
  return !std::filesystem::exists(output::manifestFile(config_.output.folder)) ||
         !output::shardManifests(config_.output.folder).empty();
}

std::optional<run::RunSummary> ParallelRun::make(run::Reporter& reporter) const {
  shareCores(config_.processes);
  if (config_.output.if_exists == output::IfExists::kOverwrite && !removeEarlier(reporter))
    return std::nullopt;
  reporter.info(std::to_string(config_.processes) + " processes make a shard each");
  const bool is_done = doInProcesses(
      config_.processes,
      [this](int shard, run::Reporter& of_shard) { return makeShard(settingsOf(shard), of_shard); },
      reporter);
  if (!is_done || reporter.stopRequested()) return std::nullopt;
  return run::mergeShards(config_.output.folder, {}, reporter);
}

Value::Map ParallelRun::settingsOf(int shard) const {
  Value::Map settings = settings_;
  settings["processes"] = Value(1);
  config::overlay(
      settings,
      {{"shard", Value(Value::Map{{"index", Value(shard)}, {"count", Value(config_.processes)}})}});
  // What was to be overwritten has already been removed.
  if (config_.output.if_exists == output::IfExists::kOverwrite)
    settings["if_exists"] = Value("resume");
  return settings;
}

/// Works in a process of its own, so that this one keeps no memory for the world that has to be
/// read.
bool ParallelRun::removeEarlier(run::Reporter& reporter) const {
  const bool is_there = std::filesystem::exists(output::manifestFile(config_.output.folder)) ||
                        !output::shardManifests(config_.output.folder).empty();
  if (!is_there) return true;
  return doInProcesses(
      1,
      [this](int, run::Reporter&) {
        run::clearOutput(Value(settings_));
        return true;
      },
      reporter);
}

}  // namespace synthetic_dataset::programs

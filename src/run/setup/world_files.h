#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/stages.h"
#include "config/config.h"
#include "run/setup/ros_packages.h"
#include "world/files/resource_finder.h"
#include "world/world_loader.h"

namespace synthetic_dataset::run {

/// A world's file and those of the models in it, each read once: motions in the same world share
/// what was read, meshes and pictures too.
class WorldFiles {
 public:
  /// @param config  of a motion
  /// @param on_stage  called when a step begins that may take long
  WorldFiles(const config::WorldConfig& config, const base::OnStage& on_stage);
  WorldFiles(const WorldFiles&) = delete;  // the loader refers to the finder
  WorldFiles& operator=(const WorldFiles&) = delete;

  /// @throws ErrorList as WorldLoader::loadWorld
  [[nodiscard]] const world::Description& world();

  /// @throws ErrorList as WorldLoader::loadModel
  /// @param name  of the object
  /// @param arguments  of a xacro file
  [[nodiscard]] const world::Model& model(const std::string& model_or_uri, const std::string& name,
                                          const world::XacroArguments& arguments = {});

  /// What was left out or replaced so far of the models.
  [[nodiscard]] const std::vector<std::string>& modelNotes() const { return loader_.modelNotes(); }

  /// The cameras of the models that were read so far.
  [[nodiscard]] const std::vector<world::CameraSensor>& modelCameras() const {
    return loader_.modelCameras();
  }

  /// Files that were named so far and may not be: there is no dataset of such a world.
  [[nodiscard]] std::vector<std::string> refusals() const {
    return {finder_.refusals().begin(), finder_.refusals().end()};
  }

  /// A line for each ROS package that cannot be read.
  [[nodiscard]] std::vector<std::string> packageNotes() const { return packages_.notes(); }

  /// The files that were read so far.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return finder_.found(); }

 private:
  std::string world_file_;
  RosPackageIndex packages_;
  world::ResourceFinder finder_;
  world::WorldLoader loader_;
  std::optional<world::Description> world_;
  using Key = std::tuple<std::string, std::string, world::XacroArguments>;  ///< URI, name
  std::map<Key, world::Model> models_;
};

/// The worlds of a run's motions.
class WorldCache {
 public:
  /// @param on_stage  called when a step begins that may take long
  explicit WorldCache(base::OnStage on_stage) : on_stage_(std::move(on_stage)) {}

  /// The files of a motion's world, the same for all motions that read them alike.
  [[nodiscard]] WorldFiles& filesFor(const config::WorldConfig& config);

 private:
  base::OnStage on_stage_;
  std::map<std::string, std::unique_ptr<WorldFiles>> files_;  ///< by all that decides what is read
};

}  // namespace synthetic_dataset::run

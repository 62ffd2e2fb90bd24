#pragma once

#include <cstdint>
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
#include "run/setup/file_stamps.h"
#include "run/setup/model_varieties.h"
#include "run/setup/package_index.h"
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
                                          const world::TemplateArguments& arguments = {});

  /// Variants of the models.
  [[nodiscard]] ModelVarieties& varieties() { return varieties_; }

  /// Whether all files that were read so far are as they were, those that were not there are still
  /// not there, and nothing was wrong with any.
  [[nodiscard]] bool areCurrent() const { return !is_unsure_ && stamps_.areCurrent(); }

  /// Another run is going to ask, as if nothing had been read yet.
  void beginUse() { asked_.clear(); }

  /// Whether what this run has asked for is all that was ever read, in its order: else notes,
  /// cameras and files are those of others, too.
  [[nodiscard]] bool areAsFresh() const { return asked_ == read_; }

  /// What was left out or replaced so far of the models.
  [[nodiscard]] const std::vector<std::string>& modelNotes() const { return loader_.modelNotes(); }

  /// The cameras of the models that were read so far.
  [[nodiscard]] const std::vector<world::CameraSensor>& modelCameras() const {
    return loader_.modelCameras();
  }

  /// Their lidars.
  [[nodiscard]] const std::vector<world::LidarSensor>& modelLidars() const {
    return loader_.modelLidars();
  }

  /// Files that were named so far and may not be: there is no dataset of such a world.
  [[nodiscard]] std::vector<std::string> refusals() const {
    return {finder_.refusals().begin(), finder_.refusals().end()};
  }

  /// A line for each ROS package that cannot be read.
  [[nodiscard]] std::vector<std::string> packageNotes() const { return packages_.notes(); }

  /// The files that were found so far by what names them: worlds, meshes, pictures.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return finder_.found(); }

  /// All others that were read so far: models' descriptions, meshes' material libraries and
  /// buffers.
  [[nodiscard]] const std::set<std::filesystem::path>& included() const { return included_; }

 private:
  using Key = std::tuple<std::string, std::string, world::TemplateArguments>;  ///< URI, name

  template <class Load>
  auto read(const Key& key, const Load& load) -> decltype(load());
  void noteAsked(const Key& key);
  void keepFiles(const std::set<std::filesystem::path>& opened);

  std::string world_file_;
  RosPackageIndex packages_;
  world::ResourceFinder finder_;
  world::WorldLoader loader_;
  std::optional<world::Description> world_;
  std::map<Key, world::Model> models_;
  ModelVarieties varieties_;
  std::vector<Key> read_;   ///< the world, which is first or has no name, and the models
  std::vector<Key> asked_;  ///< of these, in this use
  std::set<std::filesystem::path> included_;
  FileStamps stamps_;
  bool is_unsure_ = false;  ///< something failed, or was read of files that are not known
};

/// The worlds of a run's motions.
class WorldCache {
 public:
  /// @param on_stage  called when a step begins that may take long
  explicit WorldCache(base::OnStage on_stage) : on_stage_(std::move(on_stage)) {}

  /// The files of a motion's world, the same for all motions that read them alike.
  [[nodiscard]] WorldFiles& filesFor(const config::WorldConfig& config);

  /// Another run is going to ask. What has changed since it was read is let go of, and what was not
  /// asked for lately.
  void beginUse();

  /// Whether this run has got what it would have got from a new cache.
  [[nodiscard]] bool isAsFresh() const;

  /// Whether no file has changed of what was asked for by the run that asked last.
  [[nodiscard]] bool areCurrent() const;

  void clear() { worlds_.clear(); }

  /// How many worlds were read so far.
  [[nodiscard]] std::int64_t readCount() const { return read_count_; }

 private:
  struct Kept {
    std::unique_ptr<WorldFiles> files;
    int unused = 0;  ///< for how many runs nobody has asked for it
  };

  base::OnStage on_stage_;
  std::map<std::string, Kept> worlds_;  ///< by all that decides what is read
  std::int64_t read_count_ = 0;
};

}  // namespace synthetic_dataset::run

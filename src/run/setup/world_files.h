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
/// everything read, including meshes and pictures.
class WorldFiles {
 public:
  /// @param config  of a motion
  /// @param on_stage  called at the start of a step that may take long
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

  /// Whether all files read so far are unchanged, those that were missing are still missing, and
  /// none had an error.
  [[nodiscard]] bool areCurrent() const { return !is_uncacheable_ && stamps_.areCurrent(); }

  /// Begins another run, which will ask as if nothing had been read yet.
  void beginUse() { asked_.clear(); }

  /// Whether this run has asked for exactly what was ever read, in the same order; otherwise notes,
  /// cameras and files include those of other runs.
  [[nodiscard]] bool areAsFresh() const { return asked_ == read_; }

  /// Notes on what has been left out of or replaced in the models so far.
  [[nodiscard]] const std::vector<std::string>& modelNotes() const { return loader_.modelNotes(); }

  /// The cameras of the models read so far.
  [[nodiscard]] const std::vector<world::CameraSensor>& modelCameras() const {
    return loader_.modelCameras();
  }

  /// The lidars of the models read so far.
  [[nodiscard]] const std::vector<world::LidarSensor>& modelLidars() const {
    return loader_.modelLidars();
  }

  /// Files named so far that are not allowed: no dataset is made of such a world.
  [[nodiscard]] std::vector<std::string> refusals() const {
    return {finder_.refusals().begin(), finder_.refusals().end()};
  }

  /// A line for each ROS package that cannot be read.
  [[nodiscard]] std::vector<std::string> packageNotes() const { return packages_.notes(); }

  /// The files found so far by URI or path: worlds, meshes, pictures.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return finder_.found(); }

  /// All other files read so far: models' descriptions, meshes' material libraries and buffers.
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
  std::vector<Key> read_;   ///< the world (first, or without a name) and the models
  std::vector<Key> asked_;  ///< of these, by the current run
  std::set<std::filesystem::path> included_;
  FileStamps stamps_;
  bool is_uncacheable_ = false;  ///< something failed, or was read from unknown files
};

/// The worlds of a run's motions.
class WorldCache {
 public:
  /// @param on_stage  called at the start of a step that may take long
  explicit WorldCache(base::OnStage on_stage) : on_stage_(std::move(on_stage)) {}

  /// The files of a motion's world, shared by all motions that would read them identically.
  [[nodiscard]] WorldFiles& filesFor(const config::WorldConfig& config);

  /// Begins another run: releases worlds that have changed since they were read and those not used
  /// recently.
  void beginUse();

  /// Whether this run has received what it would have received from a new cache.
  [[nodiscard]] bool isAsFresh() const;

  /// Whether none of the files used by the most recent run has changed.
  [[nodiscard]] bool areCurrent() const;

  void clear() { worlds_.clear(); }

  /// How many worlds have been read so far.
  [[nodiscard]] std::int64_t readCount() const { return read_count_; }

 private:
  struct Kept {
    std::unique_ptr<WorldFiles> files;
    int unused = 0;  ///< number of runs since it was last used
  };

  base::OnStage on_stage_;
  std::map<std::string, Kept> worlds_;  ///< by everything that determines what is read
  std::int64_t read_count_ = 0;
};

}  // namespace synthetic_dataset::run

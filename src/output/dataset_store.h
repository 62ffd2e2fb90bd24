#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/files/file_system.h"
#include "output/manifest/manifest_schema.h"
#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "output/output_options.h"
#include "output/store_types.h"
#include "synthetic_dataset/output.h"

namespace synthetic_dataset::output {

/// A shard of a dataset, by where its manifest lies.
struct ShardPlace {
  std::string folder;  ///< absolute and normalised
  Shard shard;
};

/// The dataset on disk: files that appear whole or not at all, and the manifest that lists them.
class DatasetStore {
 public:
  /// Checks every folder and file for being writable, deals with what is there (`if_exists`) and
  /// starts the manifest, or goes on with it: then scenes that a kill or a power cut left half
  /// done are dropped first, with their files.
  /// @throws ErrorList with all that stands in the way: a folder that cannot be made, files of an
  ///     earlier run, a dataset of other settings (naming each that differs), another run that
  ///     writes this dataset, two writers with the same folder (or one inside another's)
  DatasetStore(const StoreOptions& options, std::vector<StoreWriter> writers,
               const RunDescription& run = {});
  ~DatasetStore();
  DatasetStore(const DatasetStore&) = delete;
  DatasetStore& operator=(const DatasetStore&) = delete;

  /// Whether the dataset was complete before: there is nothing to do, and nothing may be written.
  [[nodiscard]] bool wasComplete() const;

  /// Whether a scene is in the dataset.
  [[nodiscard]] bool hasScene(std::int64_t index) const;

  /// Encodes (equal pixels once), writes, links, and then lists the scene in the manifest.
  /// @throws Error: what could not be written and why (a full disk, ...); the scene does not count
  void commitScene(const SceneFacts& scene, const SceneFiles& files);

  /// Lists a scene without files, whose labels are not good enough: it is made, and not there.
  /// @throws Error as commitScene does
  void leaveOutScene(const SceneFacts& scene);

  /// Takes in the scenes of a shard. Its files stay where they are; where they lie in another
  /// folder, they are linked or copied.
  void takeIn(const ShardPlace& shard);

  /// Writes one file of a dataset as a whole, streaming.
  void writeDatasetFile(std::size_t writer, const std::string& path,
                        const DatasetOutput::Content& content);

  /// The same of a file that `write` makes, given the name of one that does not exist yet.
  void writeDatasetFileByName(std::size_t writer, const std::string& path,
                              const std::function<void(const std::string& file)>& write);

  /// Gives a file of a scene one more name.
  /// @throws Error where `scene_file` is no file that this writer made for a scene
  void linkDatasetFile(std::size_t writer, const std::string& path, const std::string& scene_file);

  /// The content of a file of a scene.
  /// @throws Error as linkDatasetFile does
  [[nodiscard]] std::string readSceneFile(std::size_t writer, const std::string& scene_file) const;

  /// The records of one writer, in scene order.
  [[nodiscard]] std::unique_ptr<SceneRecords> records(std::size_t writer) const;

  /// Forces what was written to the disk, unless `sync` is off.
  void flush();

  /// Marks the run as complete: what reads the manifest may rely on it. Nothing may be written
  /// after it.
  /// @param warnings  of the run as a whole, known at its end
  void complete(const std::vector<Warning>& warnings = {});

  // Of all that is in the dataset, whichever run made it.
  [[nodiscard]] StoreCounts counts() const;
  [[nodiscard]] std::map<std::string, std::int64_t> warningCounts() const;  ///< kind to count
  [[nodiscard]] std::vector<ObjectCounts> objectCounts() const;  ///< of the run's objects
  [[nodiscard]] std::vector<SplitCounts> splitCounts() const;    ///< that have scenes, by name
  [[nodiscard]] std::string manifestPath() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::output

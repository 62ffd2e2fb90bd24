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

/// A shard of a dataset, identified by the folder of its manifest.
struct ShardPlace {
  std::string folder;  ///< absolute and normalised
  Shard shard;
};

/// The dataset on disk: files that appear whole or not at all, and the manifest that lists them.
class DatasetStore {
 public:
  /// Checks that every folder and file is writable, deals with what is already there (`if_exists`),
  /// and starts the manifest or resumes it. On resuming, scenes that a kill or a power cut left
  /// half done are dropped first, along with their files.
  /// @throws ErrorList with everything that stands in the way: a folder that cannot be made, files
  ///     of an earlier run, a dataset made with other settings (naming each that differs), another
  ///     run that is writing this dataset, two writers with the same folder (or one inside
  ///     another's)
  DatasetStore(const StoreOptions& options, std::vector<StoreWriter> writers,
               const RunDescription& run = {});
  ~DatasetStore();
  DatasetStore(const DatasetStore&) = delete;
  DatasetStore& operator=(const DatasetStore&) = delete;

  /// Whether the dataset was already complete: there is nothing to do, and nothing may be written.
  [[nodiscard]] bool wasComplete() const;

  /// Whether a scene is in the dataset.
  [[nodiscard]] bool hasScene(std::int64_t index) const;

  /// Encodes the files (equal pixels once), writes and links them, then lists the scene.
  /// @throws Error saying what cannot be written and why (disk full, ...); the scene does not count
  void commitScene(const SceneFacts& scene, const SceneFiles& files);

  /// Lists a scene whose labels are not good enough: it counts as done but has no files.
  /// @throws Error as commitScene does
  void recordSkippedScene(const SceneFacts& scene);

  /// Adds the scenes of a shard. Its files stay where they are; if they are in another folder, they
  /// are linked or copied.
  void mergeShard(const ShardPlace& shard);

  /// Streams one file that belongs to the dataset as a whole.
  void writeDatasetFile(std::size_t writer, const std::string& path,
                        const DatasetOutput::Content& content);

  /// Writes a file of the dataset by calling `write` with the name of a new file.
  void writeDatasetFileByName(std::size_t writer, const std::string& path,
                              const std::function<void(const std::string& file)>& write);

  /// Gives a scene's file an additional name.
  /// @throws Error if `scene_file` is not a file that this writer made for a scene
  void linkDatasetFile(std::size_t writer, const std::string& path, const std::string& scene_file);

  /// The content of a scene's file.
  /// @throws Error as linkDatasetFile does
  [[nodiscard]] std::string readSceneFile(std::size_t writer, const std::string& scene_file) const;

  /// The records of one writer, in scene order.
  [[nodiscard]] std::unique_ptr<SceneRecords> records(std::size_t writer) const;

  /// Forces everything written so far to the disk, unless `sync` is off.
  void flush();

  /// Marks the run as complete, which readers of the manifest may rely on. Nothing may be written
  /// afterwards.
  /// @param warnings  about the run as a whole, known only at its end
  void complete(const std::vector<Warning>& warnings = {});

  // Totals over everything in the dataset, whichever run made it.
  [[nodiscard]] StoreCounts counts() const;
  [[nodiscard]] std::map<std::string, std::int64_t> warningCounts() const;  ///< kind to count
  [[nodiscard]] std::vector<ObjectCounts> objectCounts() const;  ///< one per object of the run
  [[nodiscard]] std::vector<SplitCounts> splitCounts() const;    ///< that have scenes, by name
  [[nodiscard]] std::string manifestPath() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::output

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/manifest_schema.h"
#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "output/manifest/truth_tables.h"
#include "output/output_options.h"
#include "output/store_types.h"

namespace synthetic_dataset::output {

/// A row of the manifest's table `file`.
struct ManifestFile {
  std::string path;  ///< absolute
  std::size_t writer = 0;
  std::int64_t bytes = 0;
  std::string digest = "";
  std::optional<std::string> linked_to = {};  ///< absolute path of the file with the same content
};

/// Reads a row of path, writer, bytes, digest, linked_to from a manifest in this folder.
[[nodiscard]] ManifestFile fileOf(const base::SqliteStatement& row, const std::string& folder);

/// Visits one writer's records of a channel, in scene order.
void forEachRecordOf(const base::SqliteDatabase& database, std::size_t writer,
                     const std::string& channel,
                     const std::function<void(std::int64_t, const std::string&)>& visit);

/// How far a scene has progressed. A scene that is left out has no files and counts as complete.
enum class SceneState {
  kBegun,     ///< its files may be missing
  kWritten,   ///< all its files are there
  kComplete,  ///< and they are safe from a power cut
};

/// The list of what a dataset holds: an SQLite file that the run writes scene by scene.
///
/// A scene's files are announced before they appear, and the scene is listed once they all have:
/// however a run is killed, none of its files is unknown and no listed scene is incomplete.
class Manifest {
 public:
  /// Starts a new manifest.
  /// @param folder  absolute and normalised; paths below it are listed relative to it
  static Manifest create(const std::string& folder, const std::optional<Shard>& shard, Sync sync,
                         const std::vector<StoreWriter>& writers, const RunDescription& run);

  /// Opens an unfinished manifest in order to resume it.
  /// @throws Error when it cannot be read
  static Manifest open(const std::string& folder, const std::optional<Shard>& shard, Sync sync);

  /// @throws Error if one of the files was announced before, or the scene is listed already
  void announceScene(const SceneFacts& scene, const std::vector<ManifestFile>& files);

  /// Announces a file of the dataset as a whole.
  void announce(const ManifestFile& file);

  /// Takes back a scene or files that were announced but do not exist.
  void withdrawScene(std::int64_t index);
  void withdraw(const std::string& path);

  /// Counts a scene as written.
  /// @param pictures  facts about the scene's own pictures
  void listScene(const SceneFacts& scene, const std::vector<PictureFacts>& pictures,
                 const std::vector<SceneFiles::Record>& records);

  /// Lists a scene without files, because its labels are not good enough.
  void recordSkippedScene(const SceneFacts& scene);

  /// Marks all written scenes as safe from a power cut.
  void markComplete();

  /// Whether a writer made this file for a scene.
  /// @param path  absolute
  [[nodiscard]] bool isSceneFile(std::size_t writer, const std::string& path) const;

  void setContent(const std::string& path, std::int64_t bytes, const std::string& digest);

  /// Visits one writer's records of a channel, in scene order.
  void forEachRecord(std::size_t writer, const std::string& channel,
                     const std::function<void(std::int64_t, const std::string&)>& visit) const;

  [[nodiscard]] std::map<std::int64_t, SceneState> sceneStates() const;

  /// @param scene  nothing for the files of the dataset as a whole
  [[nodiscard]] std::vector<ManifestFile> filesOfScene(std::optional<std::int64_t> scene) const;

  [[nodiscard]] StoreCounts counts() const;
  [[nodiscard]] std::map<std::string, std::int64_t> warningCounts() const;
  [[nodiscard]] std::vector<ObjectCounts> objectCounts() const;
  [[nodiscard]] std::vector<SplitCounts> splitCounts() const;

  /// Makes a file of a shard's dataset a file of this dataset.
  using PlaceFile = std::function<void(const std::string& source, const ManifestFile& target)>;

  /// Adds the scenes of a shard's manifest that are not in this one yet.
  /// @param place  called for each file that is not already in its place
  void mergeShard(const std::string& shard_folder, const Shard& shard, const PlaceFile& place);

  /// Sets the state of a dataset that is complete except for lost files back to running.
  void reopen();

  /// Sets the state to complete and rewrites the file, so that its bytes depend only on what it
  /// lists and not on how it came about. Nothing may be written afterwards; reading still works.
  /// @param warnings  about the run as a whole, known only at its end; those already listed stay
  void finish(const std::vector<Warning>& warnings = {});

  /// Whether the open file is still the one under the manifest's name.
  [[nodiscard]] bool isInPlace() const;

  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  Manifest(const std::string& folder, const std::optional<Shard>& shard,
           base::SqliteDatabase database);

  [[nodiscard]] std::string listedPath(const std::string& path) const;
  void refuseKnown(const std::string& path);
  void insertFile(std::optional<std::int64_t> scene, const ManifestFile& file);
  void insertMeasures(const SceneFacts& scene);
  void listAtEnd(const std::vector<Warning>& warnings);
  void takeInSceneOf(const std::string& shard_folder, std::int64_t index, const PlaceFile& place);

  std::string folder_;
  std::string file_;
  std::pair<std::uint64_t, std::uint64_t> identity_;  ///< device and inode of the file
  base::SqliteDatabase database_;
  base::SqliteStatement insert_file_;
  base::SqliteStatement find_file_;
  base::SqliteStatement insert_scene_;
  base::SqliteStatement find_scene_;
  base::SqliteStatement set_state_;
  base::SqliteStatement insert_object_;
  base::SqliteStatement insert_record_;
  base::SqliteStatement insert_warning_;
  TruthInserter truth_;
};

}  // namespace synthetic_dataset::output

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/sqlite.h"

namespace synthetic_dataset::output {

/// The version of the manifest's tables; docs/manifest.md describes them.
constexpr const char* kManifestVersion = "1";

/// A row of the manifest's table `file`.
struct ManifestFile {
  std::string path;  ///< absolute
  std::size_t writer = 0;
  std::int64_t bytes = 0;
  std::optional<std::string> linked_to;  ///< absolute path of the file that has the same content
};

/// The list of what a dataset holds: an SQLite file that its run writes scene by scene.
///
/// A scene's files are announced before they appear and the scene is listed when they all have:
/// whatever kills a run, no file of it is unknown and no listed scene is incomplete.
class Manifest {
 public:
  /// Starts a manifest in a folder that has none.
  /// @param folder  absolute and normalised; paths below it are listed relative to it
  Manifest(const std::string& folder, const std::vector<StoreWriter>& writers);

  /// @param scene  nothing for files of the dataset as a whole
  /// @throws Error when one of them was announced before, or the scene is listed already
  void announce(std::optional<std::int64_t> scene, const std::vector<ManifestFile>& files);

  /// Takes back files that were announced and do not exist.
  void withdraw(const std::vector<ManifestFile>& files);

  /// Counts a scene as complete.
  void listScene(std::int64_t index, Stamp stamp, const SceneFiles& scene);

  /// Whether a writer made this file for a scene.
  /// @param path  absolute
  [[nodiscard]] bool isSceneFile(std::size_t writer, const std::string& path) const;

  void setBytes(const std::string& path, std::int64_t bytes);
  void setComplete();

  /// The records of one writer in scene order.
  void forEachRecord(std::size_t writer,
                     const std::function<void(std::int64_t, const std::string&)>& visit) const;

 private:
  [[nodiscard]] std::string listedPath(const std::string& path) const;
  void refuseKnown(const ManifestFile& file);

  std::string folder_;
  SqliteDatabase database_;
  SqliteStatement insert_file_;
  SqliteStatement find_file_;
  SqliteStatement delete_file_;
  SqliteStatement insert_scene_;
  SqliteStatement find_scene_;
  SqliteStatement insert_record_;
};

/// Where a dataset's manifest lies.
[[nodiscard]] std::string manifestFile(const std::string& folder);

/// What an earlier run's manifest says.
struct ManifestContent {
  bool complete = false;
  std::int64_t scene_count = 0;
  std::vector<std::string> files;           ///< absolute
  std::vector<std::string> writer_folders;  ///< absolute
};

/// @throws Error when the file is no manifest of this version, or damaged
[[nodiscard]] ManifestContent readManifest(const std::string& folder);

}  // namespace synthetic_dataset::output

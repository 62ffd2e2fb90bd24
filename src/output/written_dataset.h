#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/manifest_content.h"
#include "output/manifest/picture_facts.h"
#include "output/store_types.h"
#include "synthetic_dataset/scene.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::output {

/// A writer as a manifest lists it.
struct WrittenWriter {
  std::int64_t index = 0;
  std::string name;
  std::string type;
  std::filesystem::path folder;  ///< absolute
  Value::Map settings;           ///< those in its own group
};

/// A scene as a manifest lists it.
struct WrittenSceneRow {
  std::string name;              ///< Scene::name
  std::size_t camera_index = 0;  ///< Scene::camera_index
  Stamp stamp{0};                ///< Scene::stamp
  std::string camera;            ///< name of the camera
  std::string split;             ///< Scene::split
};

/// A row of the manifest's table `file`, unchanged.
struct ListedFile {
  std::string path;
  std::size_t writer = 0;
  std::optional<std::int64_t> scene;  ///< nothing for a file of the dataset as a whole
  std::int64_t bytes = 0;
  std::string digest;
  std::optional<std::string> linked_to;
};

/// Totals over all scenes whose files are there.
struct WrittenCounts {
  std::int64_t scenes = 0;
  std::int64_t bytes = 0;                      ///< of all files
  std::map<std::string, std::int64_t> splits;  ///< number of scenes by split
  std::map<std::string, std::int64_t> labels;  ///< number of labels by class
};

/// A label of the dataset: an object labelled in a scene's files.
struct WrittenLabel {
  std::int64_t scene = 0;  ///< Scene::index
  std::string class_name;
  std::optional<std::int64_t> visible_pixels;  ///< nothing if they were not counted
  std::optional<double> visibility;
};

/// A dataset that a run has written, as listed by its manifest. Whatever grows with the number of
/// scenes is not held in memory as a whole. All methods throw Error if the manifest cannot be read.
class WrittenDataset {
 public:
  /// @param folder  of the manifest of a whole run
  /// @throws Error if there is none
  explicit WrittenDataset(const std::filesystem::path& folder);

  /// @param manifest  absolute path of the manifest of a whole run or a shard; it should have
  ///     passed `structureProblems`, and is not written to
  WrittenDataset(const std::string& manifest, base::SqliteDatabase::Mode mode);

  [[nodiscard]] const std::string& manifest() const { return manifest_; }
  [[nodiscard]] std::string folder() const { return folder_.string(); }  ///< of the manifest

  /// The manifest's content, except the files. Only scenes whose files are there are counted.
  [[nodiscard]] const ManifestContent& content() const;

  [[nodiscard]] const std::vector<WrittenWriter>& writers() const { return writers_; }

  /// The indices of all scenes whose files are there, in order.
  [[nodiscard]] std::vector<std::int64_t> scenes() const;

  /// The index of the scene in the middle. @throws Error if the dataset has no scenes
  [[nodiscard]] std::int64_t middleScene() const;

  /// @throws Error if the dataset has no scene with this index
  [[nodiscard]] WrittenSceneRow scene(std::int64_t index) const;

  [[nodiscard]] WrittenCounts counts() const;

  /// The split of each scene that is there, by its index.
  [[nodiscard]] std::map<std::int64_t, std::string> splitsOfScenes() const;

  /// Visits the labels of all scenes that are there, in scene order.
  void forEachLabel(const std::function<void(const WrittenLabel&)>& visit) const;

  /// Whether a file belongs to the dataset, by any of its names.
  [[nodiscard]] bool holds(const std::filesystem::path& file) const;

  /// Whether a file is listed, or is the temporary file of a listed one.
  /// @param path  absolute
  [[nodiscard]] bool lists(const std::string& path) const;
  [[nodiscard]] bool listsTemporary(const std::string& path) const;

  /// Whether a folder is a writer's folder or lies inside one.
  [[nodiscard]] bool isInAWriter(const std::filesystem::path& folder) const;

  /// Whether a writer made pictures of scenes.
  [[nodiscard]] bool hasPictures(const WrittenWriter& writer) const;

  /// The files that a writer made for a scene: absolute paths in alphabetical order.
  [[nodiscard]] std::vector<std::filesystem::path> files(const WrittenWriter& writer,
                                                         std::int64_t scene) const;

  /// Visits all scenes that are there, in order.
  void forEachScene(const std::function<void(const SceneFacts&)>& visit) const;

  /// Everything known about a scene. @throws Error if the manifest does not have it
  [[nodiscard]] SceneFacts facts(std::int64_t index) const;

  /// Visits the files of a scene, or of the dataset as a whole, by writer and then by name.
  void forEachFileOf(const std::optional<std::int64_t>& scene,
                     const std::function<void(const ListedFile&)>& visit) const;

  /// The records that a writer stored for a scene, in order.
  [[nodiscard]] std::vector<SceneFiles::Record> recordsOf(std::size_t writer,
                                                          std::int64_t scene) const;

  /// Visits the records of one channel in all scenes.
  void forEachRecord(std::size_t writer, const std::string& channel,
                     const std::function<void(std::int64_t, const std::string&)>& visit) const;

 private:
  void addMeasures(SceneFacts& scene) const;

  std::string manifest_;
  std::filesystem::path folder_;
  base::SqliteDatabase database_;
  mutable std::optional<ManifestContent> content_;  ///< set on first use
  std::vector<WrittenWriter> writers_;
  std::vector<std::string> cameras_;
};

}  // namespace synthetic_dataset::output

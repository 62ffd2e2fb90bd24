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
  Value::Map settings;           ///< its own
};

/// A scene as a manifest lists it.
struct WrittenSceneRow {
  std::string name;              ///< Scene::name
  std::size_t camera_index = 0;  ///< Scene::camera_index
  Stamp stamp{0};                ///< Scene::stamp
  std::string camera;            ///< its name
  std::string split;             ///< Scene::split
};

/// A row of the manifest's table `file`, as it stands there.
struct ListedFile {
  std::string path;
  std::size_t writer = 0;
  std::optional<std::int64_t> scene;  ///< nothing: of the dataset as a whole
  std::int64_t bytes = 0;
  std::string digest;
  std::optional<std::string> linked_to;
};

/// What all scenes together hold whose files are there.
struct WrittenCounts {
  std::int64_t scenes = 0;
  std::int64_t bytes = 0;                      ///< of all files
  std::map<std::string, std::int64_t> splits;  ///< scenes of each
  std::map<std::string, std::int64_t> labels;  ///< of each class
};

/// A label of the dataset: an object that a scene's files have.
struct WrittenLabel {
  std::int64_t scene = 0;  ///< Scene::index
  std::string class_name;
  std::optional<std::int64_t> visible_pixels;  ///< nothing where they were not counted
  std::optional<double> visibility;
};

/// A dataset that a run has written, as its manifest lists it. What grows with the number of scenes
/// is not held as a whole. All methods throw Error where the manifest cannot be read.
class WrittenDataset {
 public:
  /// @param folder  of the manifest of a whole run
  /// @throws Error when there is none
  explicit WrittenDataset(const std::filesystem::path& folder);

  /// @param manifest  its absolute path, of a whole run or a shard; it should have passed
  ///     `structureProblems`, and is not written to
  WrittenDataset(const std::string& manifest, base::SqliteDatabase::Mode mode);

  [[nodiscard]] const std::string& manifest() const { return manifest_; }
  [[nodiscard]] std::string folder() const { return folder_.string(); }  ///< of the manifest

  /// All but the files. Scenes are counted that are there.
  [[nodiscard]] const ManifestContent& content() const;

  [[nodiscard]] const std::vector<WrittenWriter>& writers() const { return writers_; }

  /// The indices of all scenes whose files are there, in order.
  [[nodiscard]] std::vector<std::int64_t> scenes() const;

  /// The index of a scene in the middle. @throws Error when the dataset has no scene
  [[nodiscard]] std::int64_t middleScene() const;

  /// @throws Error when the dataset has no scene of this index
  [[nodiscard]] WrittenSceneRow scene(std::int64_t index) const;

  [[nodiscard]] WrittenCounts counts() const;

  /// The split of each scene that is there, by its index.
  [[nodiscard]] std::map<std::int64_t, std::string> splitsOfScenes() const;

  /// The labels of all scenes that are there, scene by scene, in their order.
  void forEachLabel(const std::function<void(const WrittenLabel&)>& visit) const;

  /// Whether a file is one of the dataset's, by whichever of its names.
  [[nodiscard]] bool holds(const std::filesystem::path& file) const;

  /// Whether a file is listed, or is the temporary file of a listed one.
  /// @param path  absolute
  [[nodiscard]] bool lists(const std::string& path) const;
  [[nodiscard]] bool listsTemporary(const std::string& path) const;

  /// Whether a folder is a writer's, or lies in it.
  [[nodiscard]] bool isInAWriter(const std::filesystem::path& folder) const;

  /// Whether a writer made pictures of scenes.
  [[nodiscard]] bool hasPictures(const WrittenWriter& writer) const;

  /// The files that a writer made of a scene: absolute, in alphabetical order.
  [[nodiscard]] std::vector<std::filesystem::path> files(const WrittenWriter& writer,
                                                         std::int64_t scene) const;

  /// All scenes that are there, in their order.
  void forEachScene(const std::function<void(const SceneFacts&)>& visit) const;

  /// All that is known of one. @throws Error when the manifest does not have it
  [[nodiscard]] SceneFacts facts(std::int64_t index) const;

  /// The files of a scene, or of the dataset as a whole, writer by writer in the order of their
  /// names.
  void forEachFileOf(const std::optional<std::int64_t>& scene,
                     const std::function<void(const ListedFile&)>& visit) const;

  /// What a writer has kept of a scene, in its order.
  [[nodiscard]] std::vector<SceneFiles::Record> recordsOf(std::size_t writer,
                                                          std::int64_t scene) const;

  /// The same of all scenes, of one channel.
  void forEachRecord(std::size_t writer, const std::string& channel,
                     const std::function<void(std::int64_t, const std::string&)>& visit) const;

 private:
  void addMeasures(SceneFacts& scene) const;

  std::string manifest_;
  std::filesystem::path folder_;
  base::SqliteDatabase database_;
  mutable std::optional<ManifestContent> content_;  ///< once it was asked for
  std::vector<WrittenWriter> writers_;
  std::vector<std::string> cameras_;
};

}  // namespace synthetic_dataset::output

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "output/manifest/sqlite.h"
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

/// What all scenes together hold whose files are there.
struct WrittenCounts {
  std::int64_t scenes = 0;
  std::int64_t bytes = 0;                      ///< of all files
  std::map<std::string, std::int64_t> splits;  ///< scenes of each
  std::map<std::string, std::int64_t> labels;  ///< of each class
};

/// A dataset that a run has written, as its manifest lists it.
class WrittenDataset {
 public:
  /// @param folder  of the manifest
  /// @throws Error when there is none or it cannot be read
  explicit WrittenDataset(const std::filesystem::path& folder);

  [[nodiscard]] const std::vector<WrittenWriter>& writers() const { return writers_; }

  /// The indices of all scenes whose files are there, in order.
  [[nodiscard]] std::vector<std::int64_t> scenes() const;

  /// The index of a scene in the middle. @throws Error when the dataset has no scene
  [[nodiscard]] std::int64_t middleScene() const;

  /// @throws Error when the dataset has no scene of this index
  [[nodiscard]] WrittenSceneRow scene(std::int64_t index) const;

  [[nodiscard]] WrittenCounts counts() const;

  /// Whether a file is one of the dataset's, by whichever of its names.
  [[nodiscard]] bool lists(const std::filesystem::path& file) const;

  /// Whether a folder is a writer's, or lies in it.
  [[nodiscard]] bool isInAWriter(const std::filesystem::path& folder) const;

  /// Whether a writer made pictures of scenes.
  [[nodiscard]] bool hasPictures(const WrittenWriter& writer) const;

  /// The files that a writer made of a scene: absolute, in alphabetical order.
  [[nodiscard]] std::vector<std::filesystem::path> files(const WrittenWriter& writer,
                                                         std::int64_t scene) const;

 private:
  std::filesystem::path folder_;
  SqliteDatabase database_;
  std::vector<WrittenWriter> writers_;
  std::vector<std::string> cameras_;
};

}  // namespace synthetic_dataset::output

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output/manifest/manifest_content.h"
#include "output/manifest/picture_facts.h"
#include "output/manifest/sqlite.h"
#include "output/store_types.h"

namespace synthetic_dataset::output {

/// A row of the manifest's table `file`, as it stands there.
struct ListedFile {
  std::string path;
  std::size_t writer = 0;
  std::optional<std::int64_t> scene;  ///< nothing: of the dataset as a whole
  std::int64_t bytes = 0;
  std::string digest;
  std::optional<std::string> linked_to;
};

/// A dataset as one manifest lists it, to be read from beginning to end: what grows with the number
/// of scenes is never held as a whole. The manifest is not written to.
class ListedDataset {
 public:
  /// @param manifest  its absolute path; it should have passed `structureProblems`
  /// @throws Error when it cannot be read, also in all other methods
  explicit ListedDataset(const std::string& manifest);

  [[nodiscard]] const std::string& manifest() const { return manifest_; }
  [[nodiscard]] const std::string& folder() const { return folder_; }  ///< of the manifest

  /// All but the files. Scenes are counted that are there.
  [[nodiscard]] const ManifestContent& content() const { return content_; }

  /// Whether a file is listed, or is the temporary file of a listed one.
  /// @param path  absolute
  [[nodiscard]] bool lists(const std::string& path) const;
  [[nodiscard]] bool listsTemporary(const std::string& path) const;

  /// All scenes that are there, in their order.
  void forEachScene(const std::function<void(const SceneFacts&)>& visit) const;

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
  std::string folder_;
  SqliteDatabase database_;
  ManifestContent content_;
};

}  // namespace synthetic_dataset::output

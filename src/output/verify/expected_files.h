#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/store_types.h"
#include "output/writers/ready_writer.h"

namespace synthetic_dataset::output {

/// A temporary folder with the files that a writer should have made, so that they can be read in
/// the same way as the writer's own.
class ExpectedFiles {
 public:
  /// @param writer  outlives this
  explicit ExpectedFiles(const ReadyWriter& writer);
  ~ExpectedFiles();
  ExpectedFiles(const ExpectedFiles&) = delete;
  ExpectedFiles& operator=(const ExpectedFiles&) = delete;

  /// The path in this folder for one of the writer's files.
  /// @param path  absolute
  [[nodiscard]] std::filesystem::path placeOf(const std::string& path) const;

  /// Adds the files of a scene.
  /// @throws Error when they cannot be written
  void addScene(const SceneFiles& scene) const;

  /// Adds a file that is already right.
  /// @param path  absolute
  void addRight(const std::string& path) const;

  /// Adds the files of the dataset as a whole.
  void addDataset(const SceneRecords& records) const;

  /// All files of a scene, in alphabetical order.
  [[nodiscard]] std::vector<std::filesystem::path> filesOf(const SceneFiles& scene) const;

  [[nodiscard]] std::filesystem::path folder() const { return folder_ / "writer"; }

 private:
  const ReadyWriter& writer_;
  std::filesystem::path folder_;
};

/// The records of one scene.
class RecordsOfScene : public SceneRecords {
 public:
  /// @param records  outlive this
  RecordsOfScene(std::int64_t scene, const std::vector<SceneFiles::Record>& records)
      : scene_(scene), records_(records) {}

  void forEach(const std::string& channel,
               const std::function<void(std::int64_t scene_index, const std::string& record)>&
                   visit) const override;

 private:
  std::int64_t scene_;
  const std::vector<SceneFiles::Record>& records_;
};

}  // namespace synthetic_dataset::output

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "output/manifest/sqlite.h"

/// The tables that hold what labels are held against: cameras, shapes, keypoints, masks, pictures;
/// and who made the inputs.
namespace synthetic_dataset::output {

/// The tables, as SQL.
extern const char* const kTruthTables;

/// Those of them with a row for each scene, or several; their column `scene`.
[[nodiscard]] const std::vector<std::string>& truthTablesOfScenes();

/// What is known before the first scene.
void insertTruth(const SqliteDatabase& database, const RunDescription& run);

/// Inserts what is true of scenes.
class TruthInserter {
 public:
  explicit TruthInserter(const SqliteDatabase& database);

  void insert(const SceneFacts& scene, const std::vector<PictureFacts>& pictures);

  /// How well labels meet the recorded picture, what hides it, and nothing else.
  void insertPictureFit(const SceneFacts& scene);

 private:
  void insertObject(std::int64_t scene, std::int64_t object, const ObjectFacts& facts);

  SqliteStatement camera_;
  SqliteStatement frame_;
  SqliteStatement picture_;
  SqliteStatement link_map_;
  SqliteStatement shape_;
  SqliteStatement keypoint_;
  SqliteStatement alignment_;
  SqliteStatement object_alignment_;
  SqliteStatement cover_;
  SqliteStatement object_cover_;
};

/// Adds to a run's description what its manifest knows of it.
void readTruth(const SqliteDatabase& database, RunDescription& run);

/// Adds to a scene's facts, which has its objects already, what the manifest knows of it.
/// @param pictures  gets its pictures
void readTruth(const SqliteDatabase& database, SceneFacts& scene);

}  // namespace synthetic_dataset::output

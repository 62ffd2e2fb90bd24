#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"

/// The tables that hold what labels are held against: cameras, shapes, keypoints, masks, pictures;
/// and who made the inputs.
namespace synthetic_dataset::output {

/// The tables, as SQL.
extern const char* const kTruthTables;

/// Those of them with a row for each scene, or several; their column `scene`.
[[nodiscard]] const std::vector<std::string>& truthTablesOfScenes();

/// What is known before the first scene.
void insertTruth(const base::SqliteDatabase& database, const RunDescription& run);

/// Inserts what is true of scenes.
class TruthInserter {
 public:
  explicit TruthInserter(const base::SqliteDatabase& database);

  void insert(const SceneFacts& scene, const std::vector<PictureFacts>& pictures);

  /// How well labels meet the recorded picture, what hides it, and nothing else.
  void insertPictureFit(const SceneFacts& scene);

 private:
  void insertObject(std::int64_t scene, std::int64_t object, const ObjectFacts& facts);

  base::SqliteStatement camera_;
  base::SqliteStatement frame_;
  base::SqliteStatement picture_;
  base::SqliteStatement link_map_;
  base::SqliteStatement shape_;
  base::SqliteStatement keypoint_;
  base::SqliteStatement alignment_;
  base::SqliteStatement object_alignment_;
  base::SqliteStatement cover_;
  base::SqliteStatement object_cover_;
};

/// Adds to a run's description what its manifest knows of it.
void readTruth(const base::SqliteDatabase& database, RunDescription& run);

/// Adds to a scene's facts, which has its objects already, what the manifest knows of it.
/// @param pictures  gets its pictures
void readTruth(const base::SqliteDatabase& database, SceneFacts& scene);

}  // namespace synthetic_dataset::output

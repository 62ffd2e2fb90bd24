#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"

/// The tables that labels are checked against: cameras, shapes, keypoints, masks, pictures; and the
/// authors of the inputs.
namespace synthetic_dataset::output {

/// The tables, as SQL.
extern const char* const kTruthTables;

/// Those of the tables with one or more rows for each scene, in the column `scene`.
[[nodiscard]] const std::vector<std::string>& truthTablesOfScenes();

/// Inserts what is known before the first scene.
void insertTruth(const base::SqliteDatabase& database, const RunDescription& run);

/// Inserts the truth about scenes.
class TruthInserter {
 public:
  explicit TruthInserter(const base::SqliteDatabase& database);

  void insert(const SceneFacts& scene, const std::vector<PictureFacts>& pictures);

  /// Inserts only how well labels match the recorded picture, and what covers the objects.
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

/// Adds to a run's description what its manifest holds about it.
void readTruth(const base::SqliteDatabase& database, RunDescription& run);

/// Adds to a scene's facts, which already list its objects, what the manifest holds about it.
/// @param scene  receives its pictures as well
void readTruth(const base::SqliteDatabase& database, SceneFacts& scene);

}  // namespace synthetic_dataset::output

/// Takes in the scenes of shards.

#include <string>
#include <vector>

#include "output/manifest/manifest.h"
#include "output/manifest/manifest_paths.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// Tables with further data about scenes, by their column `scene`.
std::vector<std::string> measures() {
  std::vector<std::string> tables = {"scene_object", "contact", "draw", "record", "warning"};
  const std::vector<std::string>& truth = truthTablesOfScenes();
  tables.insert(tables.end(), truth.begin(), truth.end());
  return tables;
}

std::string copying(const std::string& table, const std::string& condition) {
  return "INSERT INTO main." + table + " SELECT * FROM shard." + table + " WHERE " + condition;
}

/// Another manifest with the same tables, attached to a connection as `shard`.
class Attached {
 public:
  Attached(const base::SqliteDatabase& database, const std::string& file) : database_(database) {
    base::SqliteStatement(database_, "ATTACH ? AS shard").run(file);
  }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;
  ~Attached() {
    try {
      database_.execute("DETACH shard");
    } catch (const Error&) {
      // Another error is already being thrown; closing the connection detaches as well.
    }
  }

 private:
  const base::SqliteDatabase& database_;
};

}  // namespace

void Manifest::mergeShard(const std::string& shard_folder, const Shard& shard,
                          const PlaceFile& place) {
  const Attached attached(database_, manifestFile(shard_folder, shard));
  const std::string missing = "NOT IN (SELECT \"index\" FROM main.scene)";
  if (shard_folder == folder_) {
    // All files are already in place, so everything can be added in one transaction.
    base::SqliteTransaction transaction(database_);
    for (const std::string& table : measures()) {
      database_.execute(copying(table, "scene >= 0 AND scene " + missing));
    }
    database_.execute(copying("file", "scene " + missing));
    database_.execute(copying("scene", "\"index\" " + missing));
    transaction.commit();
    return;
  }
  std::vector<std::int64_t> indices;
  {
    base::SqliteStatement rows(
        database_, "SELECT \"index\" FROM shard.scene WHERE \"index\" " + missing + " ORDER BY 1");
    while (rows.step()) indices.push_back(rows.integer(0));
  }
  for (const std::int64_t index : indices) takeInSceneOf(shard_folder, index, place);
}

void Manifest::takeInSceneOf(const std::string& shard_folder, std::int64_t index,
                             const PlaceFile& place) {
  struct Move {
    std::string source;
    ManifestFile target;
  };
  std::vector<Move> moves;
  std::vector<ManifestFile> in_place;  // files of writers that use the same folder for all shards
  base::SqliteStatement rows(
      database_, "SELECT path, writer, bytes, digest, linked_to FROM shard.file WHERE scene = ?");
  for (rows.start(index); rows.step();) {
    ManifestFile file = fileOf(rows, folder_);
    std::string source = absoluteFrom(shard_folder, rows.text(0));
    if (source == file.path) {
      in_place.push_back(std::move(file));
    } else {
      moves.push_back({std::move(source), std::move(file)});
    }
  }
  {
    base::SqliteTransaction transaction(database_);
    base::SqliteStatement(database_, copying("scene", "\"index\" = ?")).run(index);
    set_state_.run(std::string("begun"), index);
    for (const Move& move : moves) insertFile(index, move.target);
    transaction.commit();
  }
  for (const Move& move : moves) place(move.source, move.target);
  base::SqliteTransaction transaction(database_);
  for (const ManifestFile& file : in_place) insertFile(index, file);
  for (const std::string& table : measures()) {
    base::SqliteStatement(database_, copying(table, "scene = ?")).run(index);
  }
  base::SqliteStatement state(database_, "SELECT state FROM shard.scene WHERE \"index\" = ?");
  state.start(index);
  const bool is_left_out = state.step() && state.text(0) == "left out";
  set_state_.run(std::string(is_left_out ? "left out" : "written"), index);
  transaction.commit();
}

}  // namespace synthetic_dataset::output

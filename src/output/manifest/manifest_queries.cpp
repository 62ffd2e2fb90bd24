/// Queries on a manifest that is being written.

#include <string>

#include "output/manifest/manifest.h"
#include "output/manifest/manifest_paths.h"

namespace synthetic_dataset::output {
namespace {

/// Condition on a row of scene_object: the object should have a label (ObjectCounts::labelled).
const std::string kIsLabelled = "NOT dropped AND coalesce(visible_pixels > 0, in_view)";

SceneState stateOf(const std::string& text) {
  if (text == "complete" || text == "left out") return SceneState::kComplete;
  return text == "written" ? SceneState::kWritten : SceneState::kBegun;
}

}  // namespace

ManifestFile fileOf(const base::SqliteStatement& row, const std::string& folder) {
  ManifestFile file;
  file.path = absoluteFrom(folder, row.text(0));
  file.writer = static_cast<std::size_t>(row.integer(1));
  file.bytes = row.integer(2);
  file.digest = row.text(3);
  if (!row.isNull(4)) file.linked_to = absoluteFrom(folder, row.text(4));
  return file;
}

bool Manifest::isSceneFile(std::size_t writer, const std::string& path) const {
  base::SqliteStatement find(
      database_, "SELECT 1 FROM file WHERE path = ? AND writer = ? AND scene IS NOT NULL");
  find.start(listedPath(path), static_cast<std::int64_t>(writer));
  return find.step();
}

void forEachRecordOf(const base::SqliteDatabase& database, std::size_t writer,
                     const std::string& channel,
                     const std::function<void(std::int64_t, const std::string&)>& visit) {
  const std::string heading = channel + '\n';
  base::SqliteStatement records(
      database, "SELECT scene, text FROM record WHERE writer = ? ORDER BY scene, sequence");
  records.start(static_cast<std::int64_t>(writer));
  while (records.step()) {
    const std::string text = records.text(1);
    if (text.compare(0, heading.size(), heading) != 0) continue;
    visit(records.integer(0), text.substr(heading.size()));
  }
}

void Manifest::forEachRecord(
    std::size_t writer, const std::string& channel,
    const std::function<void(std::int64_t, const std::string&)>& visit) const {
  forEachRecordOf(database_, writer, channel, visit);
}

std::map<std::int64_t, SceneState> Manifest::sceneStates() const {
  std::map<std::int64_t, SceneState> states;
  base::SqliteStatement rows(database_, "SELECT \"index\", state FROM scene");
  while (rows.step()) states.emplace(rows.integer(0), stateOf(rows.text(1)));
  return states;
}

std::vector<ManifestFile> Manifest::filesOfScene(std::optional<std::int64_t> scene) const {
  std::vector<ManifestFile> files;
  base::SqliteStatement rows(
      database_, "SELECT path, writer, bytes, digest, linked_to FROM file WHERE scene IS ?");
  for (rows.start(scene); rows.step();) files.push_back(fileOf(rows, folder_));
  return files;
}

StoreCounts Manifest::counts() const {
  StoreCounts counts;
  base::SqliteStatement scenes(database_,
                               "SELECT count(*) FROM scene WHERE state IN ('written', 'complete')");
  scenes.step();
  counts.scenes = scenes.integer(0);
  base::SqliteStatement files(
      database_,
      "SELECT count(*), coalesce(sum(CASE WHEN linked_to IS NULL THEN bytes ELSE 0 END), 0) "
      "FROM file");
  files.step();
  counts.files = files.integer(0);
  counts.bytes = files.integer(1);
  return counts;
}

std::map<std::string, std::int64_t> Manifest::warningCounts() const {
  std::map<std::string, std::int64_t> counts;
  base::SqliteStatement rows(database_, "SELECT kind, sum(count) FROM warning GROUP BY kind");
  while (rows.step()) counts.emplace(rows.text(0), rows.integer(1));
  return counts;
}

std::vector<ObjectCounts> Manifest::objectCounts() const {
  std::vector<ObjectCounts> counts;
  base::SqliteStatement rows(
      database_,
      "SELECT count(scene) FILTER (WHERE in_view), count(scene) FILTER (WHERE visible_pixels > 0), "
      "count(scene) FILTER (WHERE in_view AND dropped), count(visible_pixels), "
      "count(scene) FILTER (WHERE " +
          kIsLabelled +
          "), "
          "count(mask_agreement), avg(mask_agreement) FROM object LEFT JOIN scene_object ON object "
          "= "
          "object.\"index\" "
          "GROUP BY object.\"index\" ORDER BY object.\"index\"");
  while (rows.step()) {
    counts.push_back({rows.integer(0), rows.integer(1), rows.integer(2), rows.integer(3),
                      rows.integer(4), rows.integer(5), rows.real(6)});
  }
  return counts;
}

std::vector<SplitCounts> Manifest::splitCounts() const {
  std::vector<SplitCounts> counts;
  base::SqliteStatement rows(
      database_,
      "SELECT split, count(*), count(*) FILTER (WHERE EXISTS (SELECT 1 FROM scene_object WHERE "
      "scene = scene.\"index\" AND " +
          kIsLabelled +
          ")) "
          "FROM scene WHERE split <> '' AND state IN ('written', 'complete') GROUP BY split "
          "ORDER BY split");
  while (rows.step()) counts.push_back({rows.text(0), rows.integer(1), rows.integer(2)});
  return counts;
}

}  // namespace synthetic_dataset::output

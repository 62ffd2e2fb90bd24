#include "output/written_dataset.h"

#include <algorithm>
#include <map>

#include "base/yaml_value.h"
#include "output/files/file_name_rules.h"
#include "output/manifest/manifest.h"
#include "output/writer_settings.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::output {

namespace {

std::string existingManifest(const std::filesystem::path& folder) {
  std::string file = manifestFile(folder.string());
  if (std::filesystem::exists(file)) return file;
  throw Error("'" + folder.string() +
              "': no dataset is there (a run leaves its manifest.sqlite in " +
              "its output_folder)");
}

std::map<std::string, Value> settingsIn(SqliteDatabase& database) {
  std::map<std::string, Value> settings;
  SqliteStatement rows(database, "SELECT name, value FROM setting");
  for (rows.start(); rows.step();) {
    const std::string name = rows.text(0);
    settings[name] = base::parseYaml(rows.text(1), "setting '" + name + "'");
  }
  return settings;
}

}  // namespace

WrittenDataset::WrittenDataset(const std::filesystem::path& folder)
    : folder_(std::filesystem::absolute(folder)),
      database_(existingManifest(folder_), SqliteDatabase::Mode::kExisting) {
  SqliteStatement rows(
      database_, "SELECT \"index\", name, type, output_folder FROM writer ORDER BY \"index\"");
  for (rows.start(); rows.step();) {
    writers_.push_back({rows.integer(0),
                        rows.text(1),
                        rows.text(2),
                        (folder_ / rows.text(3)).lexically_normal(),
                        {}});
  }
  const std::map<std::string, Value> settings = settingsIn(database_);
  for (WrittenWriter& each : writers_) each.settings = writerSettings(settings, each.name);
  SqliteStatement cameras(database_, "SELECT name FROM camera ORDER BY \"index\"");
  for (cameras.start(); cameras.step();) cameras_.push_back(cameras.text(0));
}

std::vector<std::int64_t> WrittenDataset::scenes() const {
  SqliteStatement rows(
      database_,
      "SELECT \"index\" FROM scene WHERE state IN ('written', 'complete') ORDER BY \"index\"");
  std::vector<std::int64_t> scenes;
  for (rows.start(); rows.step();) scenes.push_back(rows.integer(0));
  return scenes;
}

std::int64_t WrittenDataset::middleScene() const {
  SqliteStatement scenes(database_,
                         "SELECT \"index\" FROM scene WHERE state IN ('written', 'complete') ORDER "
                         "BY \"index\" LIMIT 1 OFFSET "
                         "(SELECT count(*) / 2 FROM scene WHERE state IN ('written', 'complete'))");
  scenes.start();
  if (!scenes.step()) throw Error("'" + folder_.string() + "': the dataset has no scenes");
  return scenes.integer(0);
}

WrittenSceneRow WrittenDataset::scene(std::int64_t index) const {
  SqliteStatement scenes(
      database_,
      "SELECT camera, instant, stamp_ns, split FROM scene WHERE \"index\" = ? AND "
      "state IN ('written', 'complete')");
  scenes.start(index);
  if (!scenes.step()) {
    (void)middleScene();  // throws for a dataset without scenes
    SqliteStatement last(database_, "SELECT coalesce(max(\"index\"), -1) FROM scene");
    last.start();
    last.step();
    throw Error("found the scene " + std::to_string(index) + "; the dataset has 0 to " +
                std::to_string(last.integer(0)));
  }
  const std::string camera = scenes.text(0);
  const auto found = std::find(cameras_.begin(), cameras_.end(), camera);
  return {(cameras_.size() > 1 ? camera + "/" : "") + sceneNumber(scenes.integer(1)),
          found == cameras_.end() ? 0 : static_cast<std::size_t>(found - cameras_.begin()),
          Stamp(scenes.integer(2)), camera, scenes.text(3)};
}

WrittenCounts WrittenDataset::counts() const {
  WrittenCounts counts;
  SqliteStatement splits(database_,
                         "SELECT split, count(*) FROM scene WHERE state IN ('written', "
                         "'complete') GROUP BY split");
  for (splits.start(); splits.step();) {
    counts.scenes += splits.integer(1);
    if (!splits.text(0).empty()) counts.splits[splits.text(0)] = splits.integer(1);
  }
  SqliteStatement bytes(database_,
                        "SELECT coalesce(sum(bytes), 0) FROM file WHERE linked_to IS NULL");
  bytes.start();
  if (bytes.step()) counts.bytes = bytes.integer(0);
  SqliteStatement labels(database_,
                         "SELECT class.name, count(scene) FILTER (WHERE NOT dropped AND "
                         "coalesce(visible_pixels > 0, in_view)) FROM class JOIN object ON "
                         "object.class = class.id LEFT JOIN scene_object ON "
                         "scene_object.object = object.\"index\" GROUP BY class.id");
  for (labels.start(); labels.step();) counts.labels[labels.text(0)] = labels.integer(1);
  return counts;
}

bool WrittenDataset::lists(const std::filesystem::path& file) const {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(file, error);
  SqliteStatement rows(database_, "SELECT path FROM file");
  for (rows.start(); rows.step();) {
    const std::filesystem::path listed = folder_ / rows.text(0);
    if (std::filesystem::weakly_canonical(listed, error) == target) return true;
  }
  return false;
}

bool WrittenDataset::isInAWriter(const std::filesystem::path& folder) const {
  const std::string path = std::filesystem::weakly_canonical(folder).string();
  return std::any_of(writers_.begin(), writers_.end(), [&](const WrittenWriter& writer) {
    return liesWithin(path, std::filesystem::weakly_canonical(writer.folder).string());
  });
}

bool WrittenDataset::hasPictures(const WrittenWriter& writer) const {
  SqliteStatement rows(database_,
                       "SELECT 1 FROM file WHERE writer = ? AND scene IS NOT NULL AND (path LIKE "
                       "'%.png' OR path LIKE '%.jpg') LIMIT 1");
  rows.start(writer.index);
  return rows.step();
}

std::vector<std::filesystem::path> WrittenDataset::files(const WrittenWriter& writer,
                                                         std::int64_t scene) const {
  SqliteStatement rows(database_,
                       "SELECT path FROM file WHERE writer = ? AND scene = ? ORDER BY path");
  std::vector<std::filesystem::path> files;
  for (rows.start(writer.index, scene); rows.step();) {
    files.push_back((folder_ / rows.text(0)).lexically_normal());
  }
  return files;
}

}  // namespace synthetic_dataset::output

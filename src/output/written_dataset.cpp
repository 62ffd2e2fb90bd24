#include "output/written_dataset.h"

#include <algorithm>
#include <map>

#include "base/yaml_value.h"
#include "output/files/file_name_rules.h"
#include "output/files/pending_file.h"
#include "output/manifest/manifest.h"
#include "output/manifest/manifest_paths.h"
#include "output/manifest/truth_tables.h"
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

std::map<std::string, Value> settingsIn(base::SqliteDatabase& database) {
  std::map<std::string, Value> settings;
  base::SqliteStatement rows(database, "SELECT name, value FROM setting");
  for (rows.start(); rows.step();) {
    const std::string name = rows.text(0);
    settings[name] = base::parseYaml(rows.text(1), "setting '" + name + "'");
  }
  return settings;
}

ListedFile fileAt(const base::SqliteStatement& row) {
  ListedFile file;
  file.path = row.text(0);
  file.writer = static_cast<std::size_t>(row.integer(1));
  if (!row.isNull(2)) file.scene = row.integer(2);
  file.bytes = row.integer(3);
  file.digest = row.text(4);
  if (!row.isNull(5)) file.linked_to = row.text(5);
  return file;
}

/// Reads seven columns: position and quaternion.
Pose poseAt(const base::SqliteStatement& row, int first) {
  return makePose({row.real(first), row.real(first + 1), row.real(first + 2)},
                  Eigen::Quaterniond(row.real(first + 6), row.real(first + 3), row.real(first + 4),
                                     row.real(first + 5)));
}

std::optional<Box> boxAt(const base::SqliteStatement& row, int first) {
  if (row.isNull(first)) return std::nullopt;
  return Box{row.real(first), row.real(first + 1), row.real(first + 2), row.real(first + 3)};
}

std::optional<std::int64_t> countAt(const base::SqliteStatement& row, int column) {
  return row.isNull(column) ? std::nullopt : std::optional(row.integer(column));
}

std::optional<double> numberAt(const base::SqliteStatement& row, int column) {
  return row.isNull(column) ? std::nullopt : std::optional(row.real(column));
}

ObjectFacts objectAt(const base::SqliteStatement& row) {
  ObjectFacts facts;
  facts.X_GO = row.isNull(0) ? std::nullopt : std::optional(poseAt(row, 0));
  facts.distance = numberAt(row, 7);
  facts.loose_box = boxAt(row, 8);
  facts.silhouette_box = boxAt(row, 12);
  facts.visible_box = boxAt(row, 16);
  facts.silhouette_pixels = countAt(row, 20);
  facts.visible_pixels = countAt(row, 21);
  facts.visibility = numberAt(row, 22);
  facts.truncation = numberAt(row, 23);
  facts.dropped = row.integer(24) != 0;
  facts.mask_agreement = numberAt(row, 25);
  return facts;
}

}  // namespace

WrittenDataset::WrittenDataset(const std::filesystem::path& folder)
    : WrittenDataset(existingManifest(std::filesystem::absolute(folder)),
                     base::SqliteDatabase::Mode::kExisting) {}

WrittenDataset::WrittenDataset(const std::string& manifest, base::SqliteDatabase::Mode mode)
    : manifest_(manifest),
      folder_(std::filesystem::path(manifest).parent_path()),
      database_(manifest, mode) {
  base::SqliteStatement rows(
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
  base::SqliteStatement cameras(database_, "SELECT name FROM camera ORDER BY \"index\"");
  for (cameras.start(); cameras.step();) cameras_.push_back(cameras.text(0));
}

const ManifestContent& WrittenDataset::content() const {
  if (!content_) content_ = readWithoutFiles(database_, folder());
  return *content_;
}

std::vector<std::int64_t> WrittenDataset::scenes() const {
  base::SqliteStatement rows(
      database_,
      "SELECT \"index\" FROM scene WHERE state IN ('written', 'complete') ORDER BY \"index\"");
  std::vector<std::int64_t> scenes;
  for (rows.start(); rows.step();) scenes.push_back(rows.integer(0));
  return scenes;
}

std::int64_t WrittenDataset::middleScene() const {
  base::SqliteStatement scenes(
      database_,
      "SELECT \"index\" FROM scene WHERE state IN ('written', 'complete') ORDER "
      "BY \"index\" LIMIT 1 OFFSET "
      "(SELECT count(*) / 2 FROM scene WHERE state IN ('written', 'complete'))");
  scenes.start();
  if (!scenes.step()) throw Error("'" + folder_.string() + "': the dataset has no scenes");
  return scenes.integer(0);
}

WrittenSceneRow WrittenDataset::scene(std::int64_t index) const {
  base::SqliteStatement scenes(
      database_,
      "SELECT camera, instant, stamp_ns, split FROM scene WHERE \"index\" = ? AND "
      "state IN ('written', 'complete')");
  scenes.start(index);
  if (!scenes.step()) {
    (void)middleScene();  // throws for a dataset without scenes
    base::SqliteStatement last(database_, "SELECT coalesce(max(\"index\"), -1) FROM scene");
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
  base::SqliteStatement splits(database_,
                               "SELECT split, count(*) FROM scene WHERE state IN ('written', "
                               "'complete') GROUP BY split");
  for (splits.start(); splits.step();) {
    counts.scenes += splits.integer(1);
    if (!splits.text(0).empty()) counts.splits[splits.text(0)] = splits.integer(1);
  }
  base::SqliteStatement bytes(database_,
                              "SELECT coalesce(sum(bytes), 0) FROM file WHERE linked_to IS NULL");
  bytes.start();
  if (bytes.step()) counts.bytes = bytes.integer(0);
  base::SqliteStatement labels(database_,
                               "SELECT class.name, count(scene) FILTER (WHERE NOT dropped AND "
                               "coalesce(visible_pixels > 0, in_view)) FROM class JOIN object ON "
                               "object.class = class.id LEFT JOIN scene_object ON "
                               "scene_object.object = object.\"index\" GROUP BY class.id");
  for (labels.start(); labels.step();) counts.labels[labels.text(0)] = labels.integer(1);
  return counts;
}

std::map<std::int64_t, std::string> WrittenDataset::splitsOfScenes() const {
  base::SqliteStatement rows(
      database_, "SELECT \"index\", split FROM scene WHERE state IN ('written', 'complete')");
  std::map<std::int64_t, std::string> splits;
  for (rows.start(); rows.step();) splits.emplace(rows.integer(0), rows.text(1));
  return splits;
}

void WrittenDataset::forEachLabel(const std::function<void(const WrittenLabel&)>& visit) const {
  base::SqliteStatement rows(
      database_,
      "SELECT scene.\"index\", class.name, visible_pixels, visibility FROM scene JOIN scene_object "
      "ON scene_object.scene = scene.\"index\" JOIN object ON object.\"index\" = "
      "scene_object.object JOIN class ON class.id = object.class WHERE state IN ('written', "
      "'complete') AND NOT dropped AND coalesce(visible_pixels > 0, in_view) ORDER BY 1, "
      "scene_object.object");
  for (rows.start(); rows.step();) {
    visit({rows.integer(0), rows.text(1), countAt(rows, 2), numberAt(rows, 3)});
  }
}

bool WrittenDataset::holds(const std::filesystem::path& file) const {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(file, error);
  base::SqliteStatement rows(database_, "SELECT path FROM file");
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
  base::SqliteStatement rows(
      database_,
      "SELECT 1 FROM file WHERE writer = ? AND scene IS NOT NULL AND (path LIKE "
      "'%.png' OR path LIKE '%.jpg') LIMIT 1");
  rows.start(writer.index);
  return rows.step();
}

std::vector<std::filesystem::path> WrittenDataset::files(const WrittenWriter& writer,
                                                         std::int64_t scene) const {
  base::SqliteStatement rows(database_,
                             "SELECT path FROM file WHERE writer = ? AND scene = ? ORDER BY path");
  std::vector<std::filesystem::path> files;
  for (rows.start(writer.index, scene); rows.step();) {
    files.push_back((folder_ / rows.text(0)).lexically_normal());
  }
  return files;
}

bool WrittenDataset::lists(const std::string& path) const {
  base::SqliteStatement find(database_, "SELECT 1 FROM file WHERE path = ?");
  find.start(listedPath(folder(), path));
  return find.step();
}

bool WrittenDataset::listsTemporary(const std::string& path) const {
  // A temporary file's name contains that of the file, unless the latter is long.
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  const std::string name = path.substr(folder.size());
  const std::string end = ".tmp";
  if (name.size() <= 1 + end.size() || name.front() != '.' ||
      name.compare(name.size() - end.size(), end.size(), end) != 0) {
    return false;
  }
  if (lists(folder + name.substr(1, name.size() - 1 - end.size()))) return true;
  const std::string beginning = listedPath(this->folder(), folder);
  base::SqliteStatement rows(
      database_,
      "SELECT path FROM file WHERE path >= ?1 AND substr(path, 1, length(?1)) = "
      "?1 AND length(path) > length(?1) + 200");
  for (rows.start(beginning == "./" ? std::string() : beginning); rows.step();) {
    if (temporaryPath(absoluteFrom(this->folder(), rows.text(0))) == path) return true;
  }
  return false;
}

void WrittenDataset::forEachScene(const std::function<void(const SceneFacts&)>& visit) const {
  for (const std::int64_t index : scenes()) visit(facts(index));
}

SceneFacts WrittenDataset::facts(std::int64_t index) const {
  base::SqliteStatement row(
      database_,
      "SELECT \"index\", stamp_ns, instant, camera, split, seed, x, y, z, qx, qy, qz, qw, width, "
      "height FROM scene WHERE \"index\" = ?");
  row.start(index);
  if (!row.step()) throw Error("the manifest has no scene " + std::to_string(index));
  SceneFacts scene;
  scene.index = row.integer(0);
  scene.stamp = Stamp(row.integer(1));
  scene.instant = row.integer(2);
  scene.camera = row.text(3);
  scene.split = row.text(4);
  scene.seed = static_cast<std::uint64_t>(row.integer(5));
  scene.X_GC = poseAt(row, 6);
  scene.width = static_cast<int>(row.integer(13));
  scene.height = static_cast<int>(row.integer(14));
  addMeasures(scene);
  return scene;
}

void WrittenDataset::addMeasures(SceneFacts& scene) const {
  base::SqliteStatement objects(
      database_,
      "SELECT x, y, z, qx, qy, qz, qw, distance, loose_left, loose_top, loose_right, "
      "loose_bottom, silhouette_left, silhouette_top, silhouette_right, silhouette_bottom, "
      "visible_left, visible_top, visible_right, visible_bottom, silhouette_pixels, "
      "visible_pixels, visibility, truncation, dropped, mask_agreement FROM scene_object WHERE "
      "scene = ? ORDER BY object");
  for (objects.start(scene.index); objects.step();) scene.objects.push_back(objectAt(objects));
  base::SqliteStatement warnings(
      database_, "SELECT kind, detail, count FROM warning WHERE scene = ? ORDER BY sequence");
  for (warnings.start(scene.index); warnings.step();) {
    scene.warnings.push_back({warnings.text(0), warnings.text(1), warnings.integer(2)});
  }
  if (content().is_current) readTruth(database_, scene);
}

void WrittenDataset::forEachFileOf(const std::optional<std::int64_t>& scene,
                                   const std::function<void(const ListedFile&)>& visit) const {
  base::SqliteStatement rows(
      database_,
      "SELECT path, writer, scene, bytes, digest, linked_to FROM file WHERE scene "
      "IS ? ORDER BY writer, path");
  for (rows.start(scene); rows.step();) visit(fileAt(rows));
}

std::vector<SceneFiles::Record> WrittenDataset::recordsOf(std::size_t writer,
                                                          std::int64_t scene) const {
  base::SqliteStatement rows(
      database_, "SELECT text FROM record WHERE writer = ? AND scene = ? ORDER BY sequence");
  std::vector<SceneFiles::Record> records;
  for (rows.start(static_cast<std::int64_t>(writer), scene); rows.step();) {
    const std::string text = rows.text(0);
    const std::size_t end = std::min(text.find('\n'), text.size());
    records.push_back({writer, text.substr(0, end), text.substr(std::min(end + 1, text.size()))});
  }
  return records;
}

void WrittenDataset::forEachRecord(
    std::size_t writer, const std::string& channel,
    const std::function<void(std::int64_t, const std::string&)>& visit) const {
  forEachRecordOf(database_, writer, channel, visit);
}

}  // namespace synthetic_dataset::output

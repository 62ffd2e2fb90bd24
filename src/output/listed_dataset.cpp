#include "output/listed_dataset.h"

#include <algorithm>
#include <filesystem>

#include "output/files/pending_file.h"
#include "output/manifest/manifest.h"
#include "output/manifest/manifest_paths.h"
#include "output/manifest/truth_tables.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

ListedFile fileAt(const SqliteStatement& row) {
  ListedFile file;
  file.path = row.text(0);
  file.writer = static_cast<std::size_t>(row.integer(1));
  if (!row.isNull(2)) file.scene = row.integer(2);
  file.bytes = row.integer(3);
  file.digest = row.text(4);
  if (!row.isNull(5)) file.linked_to = row.text(5);
  return file;
}

/// From seven columns: position and quaternion.
Pose poseAt(const SqliteStatement& row, int first) {
  return makePose({row.real(first), row.real(first + 1), row.real(first + 2)},
                  Eigen::Quaterniond(row.real(first + 6), row.real(first + 3), row.real(first + 4),
                                     row.real(first + 5)));
}

std::optional<Box> boxAt(const SqliteStatement& row, int first) {
  if (row.isNull(first)) return std::nullopt;
  return Box{row.real(first), row.real(first + 1), row.real(first + 2), row.real(first + 3)};
}

std::optional<std::int64_t> countAt(const SqliteStatement& row, int column) {
  return row.isNull(column) ? std::nullopt : std::optional(row.integer(column));
}

std::optional<double> numberAt(const SqliteStatement& row, int column) {
  return row.isNull(column) ? std::nullopt : std::optional(row.real(column));
}

ObjectFacts objectAt(const SqliteStatement& row) {
  ObjectFacts facts;
  facts.X_GO = row.isNull(0) ? std::nullopt : std::optional(poseAt(row, 0));
  facts.distance = numberAt(row, 7);
  facts.in_view = row.integer(8) != 0;
  facts.loose_box = boxAt(row, 9);
  facts.silhouette_box = boxAt(row, 13);
  facts.visible_box = boxAt(row, 17);
  facts.silhouette_pixels = countAt(row, 21);
  facts.visible_pixels = countAt(row, 22);
  facts.visibility = numberAt(row, 23);
  facts.truncation = numberAt(row, 24);
  facts.dropped = row.integer(25) != 0;
  facts.mask_agreement = numberAt(row, 26);
  return facts;
}

}  // namespace

ListedDataset::ListedDataset(const std::string& manifest)
    : manifest_(manifest),
      folder_(std::filesystem::path(manifest).parent_path().string()),
      database_(manifest, SqliteDatabase::Mode::kReadOnly),
      content_(readWithoutFiles(database_, folder_)) {}

bool ListedDataset::lists(const std::string& path) const {
  SqliteStatement find(database_, "SELECT 1 FROM file WHERE path = ?");
  find.start(listedPath(folder_, path));
  return find.step();
}

bool ListedDataset::listsTemporary(const std::string& path) const {
  // The name of the file is in that of its temporary file, unless it is a long one.
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  const std::string name = path.substr(folder.size());
  const std::string end = ".tmp";
  if (name.size() <= 1 + end.size() || name.front() != '.' ||
      name.compare(name.size() - end.size(), end.size(), end) != 0) {
    return false;
  }
  if (lists(folder + name.substr(1, name.size() - 1 - end.size()))) return true;
  const std::string beginning = listedPath(folder_, folder);
  SqliteStatement rows(database_,
                       "SELECT path FROM file WHERE path >= ?1 AND substr(path, 1, length(?1)) = "
                       "?1 AND length(path) > length(?1) + 200");
  for (rows.start(beginning == "./" ? std::string() : beginning); rows.step();) {
    if (temporaryPath(absoluteFrom(folder_, rows.text(0))) == path) return true;
  }
  return false;
}

void ListedDataset::forEachScene(const std::function<void(const SceneFacts&)>& visit) const {
  SqliteStatement rows(
      database_,
      "SELECT \"index\", stamp_ns, instant, camera, split, seed, x, y, z, qx, qy, qz, qw, width, "
      "height FROM scene WHERE state IN ('written', 'complete') ORDER BY \"index\"");
  while (rows.step()) {
    SceneFacts scene;
    scene.index = rows.integer(0);
    scene.stamp = Stamp(rows.integer(1));
    scene.instant = rows.integer(2);
    scene.camera = rows.text(3);
    scene.split = rows.text(4);
    scene.seed = static_cast<std::uint64_t>(rows.integer(5));
    scene.X_GC = poseAt(rows, 6);
    scene.width = static_cast<int>(rows.integer(13));
    scene.height = static_cast<int>(rows.integer(14));
    addMeasures(scene);
    visit(scene);
  }
}

void ListedDataset::addMeasures(SceneFacts& scene) const {
  SqliteStatement objects(
      database_,
      "SELECT x, y, z, qx, qy, qz, qw, distance, in_view, loose_left, loose_top, loose_right, "
      "loose_bottom, silhouette_left, silhouette_top, silhouette_right, silhouette_bottom, "
      "visible_left, visible_top, visible_right, visible_bottom, silhouette_pixels, "
      "visible_pixels, visibility, truncation, dropped, mask_agreement FROM scene_object WHERE "
      "scene = ? ORDER BY object");
  for (objects.start(scene.index); objects.step();) scene.objects.push_back(objectAt(objects));
  SqliteStatement warnings(
      database_, "SELECT kind, detail, count FROM warning WHERE scene = ? ORDER BY sequence");
  for (warnings.start(scene.index); warnings.step();) {
    scene.warnings.push_back({warnings.text(0), warnings.text(1), warnings.integer(2)});
  }
  if (content_.is_current) readTruth(database_, scene);
}

void ListedDataset::forEachFileOf(const std::optional<std::int64_t>& scene,
                                  const std::function<void(const ListedFile&)>& visit) const {
  SqliteStatement rows(database_,
                       "SELECT path, writer, scene, bytes, digest, linked_to FROM file WHERE scene "
                       "IS ? ORDER BY writer, path");
  for (rows.start(scene); rows.step();) visit(fileAt(rows));
}

std::vector<SceneFiles::Record> ListedDataset::recordsOf(std::size_t writer,
                                                         std::int64_t scene) const {
  SqliteStatement rows(
      database_, "SELECT text FROM record WHERE writer = ? AND scene = ? ORDER BY sequence");
  std::vector<SceneFiles::Record> records;
  for (rows.start(static_cast<std::int64_t>(writer), scene); rows.step();) {
    const std::string text = rows.text(0);
    const std::size_t end = std::min(text.find('\n'), text.size());
    records.push_back({writer, text.substr(0, end), text.substr(std::min(end + 1, text.size()))});
  }
  return records;
}

void ListedDataset::forEachRecord(
    std::size_t writer, const std::string& channel,
    const std::function<void(std::int64_t, const std::string&)>& visit) const {
  forEachRecordOf(database_, writer, channel, visit);
}

}  // namespace synthetic_dataset::output

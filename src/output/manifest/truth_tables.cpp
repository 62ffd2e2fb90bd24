#include "output/manifest/truth_tables.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "output/manifest/camera_columns.h"
#include "output/manifest/raw_numbers.h"

namespace synthetic_dataset::output {

const char* const kTruthTables = R"sql(
  CREATE TABLE credit (path TEXT PRIMARY KEY REFERENCES input (path), author TEXT NOT NULL,
                       author_in TEXT NOT NULL, license TEXT NOT NULL,
                       license_in TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE motion_rate (motion INTEGER PRIMARY KEY REFERENCES motion ("index"),
                            rate REAL NOT NULL);
  CREATE TABLE world_class ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
  CREATE TABLE split ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
                      scene_count INTEGER NOT NULL);
  CREATE TABLE camera_model (
    camera INTEGER PRIMARY KEY REFERENCES camera ("index"), fx REAL NOT NULL, fy REAL NOT NULL,
    cx REAL NOT NULL, cy REAL NOT NULL, near REAL NOT NULL, far REAL NOT NULL,
    distortion TEXT NOT NULL, coefficients TEXT NOT NULL, cutoff_angle REAL NOT NULL,
    varies INTEGER NOT NULL);
  CREATE TABLE object_keypoint (
    object INTEGER NOT NULL REFERENCES object ("index"), sequence INTEGER NOT NULL,
    name TEXT NOT NULL, PRIMARY KEY (object, sequence)) WITHOUT ROWID;
  CREATE TABLE object_part (
    object INTEGER NOT NULL REFERENCES object ("index"), sequence INTEGER NOT NULL,
    name TEXT NOT NULL, PRIMARY KEY (object, sequence)) WITHOUT ROWID;
  CREATE TABLE object_line (
    object INTEGER NOT NULL REFERENCES object ("index"), sequence INTEGER NOT NULL,
    first INTEGER NOT NULL, second INTEGER NOT NULL, PRIMARY KEY (object, sequence)) WITHOUT ROWID;
  CREATE TABLE object_model (
    object INTEGER PRIMARY KEY REFERENCES object ("index"), varies INTEGER NOT NULL, diameter REAL,
    vertices BLOB, triangles BLOB);
  CREATE TABLE scene_camera (
    scene INTEGER PRIMARY KEY REFERENCES scene ("index"), fx REAL NOT NULL, fy REAL NOT NULL,
    cx REAL NOT NULL, cy REAL NOT NULL, near REAL NOT NULL, far REAL NOT NULL,
    distortion TEXT NOT NULL, coefficients TEXT NOT NULL, cutoff_angle REAL NOT NULL);
  CREATE TABLE scene_frame (
    scene INTEGER NOT NULL REFERENCES scene ("index"), frame TEXT NOT NULL, x REAL NOT NULL,
    y REAL NOT NULL, z REAL NOT NULL, qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL,
    qw REAL NOT NULL, PRIMARY KEY (scene, frame)) WITHOUT ROWID;
  CREATE TABLE scene_picture (
    scene INTEGER NOT NULL REFERENCES scene ("index"), picture TEXT NOT NULL, digest TEXT NOT NULL,
    cells BLOB, PRIMARY KEY (scene, picture)) WITHOUT ROWID;
  CREATE TABLE scene_link_map (
    scene INTEGER NOT NULL REFERENCES scene ("index"), map TEXT NOT NULL, value INTEGER NOT NULL,
    pixels BLOB NOT NULL, PRIMARY KEY (scene, map, value)) WITHOUT ROWID;
  CREATE TABLE scene_shape (
    scene INTEGER NOT NULL REFERENCES scene ("index"),
    object INTEGER NOT NULL REFERENCES object ("index"), low_x REAL NOT NULL, low_y REAL NOT NULL,
    low_z REAL NOT NULL, high_x REAL NOT NULL, high_y REAL NOT NULL, high_z REAL NOT NULL,
    bounding_shape BLOB NOT NULL, silhouette_in_image INTEGER, silhouette BLOB, visible_mask BLOB,
    PRIMARY KEY (scene, object)) WITHOUT ROWID;
  CREATE TABLE scene_keypoint (
    scene INTEGER NOT NULL REFERENCES scene ("index"),
    object INTEGER NOT NULL REFERENCES object ("index"), sequence INTEGER NOT NULL,
    x REAL NOT NULL, y REAL NOT NULL, z REAL NOT NULL, u REAL, v REAL, state TEXT,
    PRIMARY KEY (scene, object, sequence)) WITHOUT ROWID;
  CREATE TABLE scene_alignment (
    scene INTEGER PRIMARY KEY REFERENCES scene ("index"), alignment REAL NOT NULL,
    CONSTRAINT "alignments that are not 0 to 1" CHECK (alignment BETWEEN 0 AND 1));
  CREATE TABLE object_alignment (
    scene INTEGER NOT NULL REFERENCES scene ("index"),
    object INTEGER NOT NULL REFERENCES object ("index"), alignment REAL NOT NULL,
    PRIMARY KEY (scene, object),
    CONSTRAINT "alignments that are not 0 to 1" CHECK (alignment BETWEEN 0 AND 1)) WITHOUT ROWID;
  CREATE TABLE scene_cover (
    scene INTEGER PRIMARY KEY REFERENCES scene ("index"), unmeasured REAL NOT NULL,
    covered REAL NOT NULL,
    CONSTRAINT "shares that are not 0 to 1"
      CHECK (unmeasured BETWEEN 0 AND 1 AND covered BETWEEN 0 AND 1));
  CREATE TABLE object_cover (
    scene INTEGER NOT NULL REFERENCES scene ("index"),
    object INTEGER NOT NULL REFERENCES object ("index"), unmeasured REAL NOT NULL,
    covered REAL NOT NULL, PRIMARY KEY (scene, object),
    CONSTRAINT "shares that are not 0 to 1"
      CHECK (unmeasured BETWEEN 0 AND 1 AND covered BETWEEN 0 AND 1)) WITHOUT ROWID;
)sql";

const std::vector<std::string>& truthTablesOfScenes() {
  static const std::vector<std::string> kTables = {
      "scene_camera",   "scene_frame",     "scene_picture",    "scene_link_map", "scene_shape",
      "scene_keypoint", "scene_alignment", "object_alignment", "scene_cover",    "object_cover"};
  return kTables;
}

namespace {

base::Blob modelVertices(const ObjectModel& model) {
  base::Blob blob;
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    for (int i = 0; i < 3; ++i) appendRaw(vertex.position(i), blob.bytes);
    for (int i = 0; i < 3; ++i) appendRaw(vertex.normal(i), blob.bytes);
    for (const std::uint8_t each : vertex.colour) appendRaw(each, blob.bytes);
  }
  return blob;
}

base::Blob modelTriangles(const ObjectModel& model) {
  base::Blob blob;
  for (const ObjectModel::Triangle& triangle : model.triangles) {
    for (const std::int32_t corner : triangle) appendRaw(corner, blob.bytes);
  }
  return blob;
}

ObjectModel modelOf(double diameter, std::string vertices, std::string triangles) {
  ObjectModel model;
  model.diameter = diameter;
  for (RawNumbers numbers(std::move(vertices)); !numbers.isAtEnd();) {
    ObjectModel::Vertex vertex;
    for (int i = 0; i < 3; ++i) vertex.position(i) = numbers.next<double>();
    for (int i = 0; i < 3; ++i) vertex.normal(i) = numbers.next<double>();
    for (std::uint8_t& each : vertex.colour) each = numbers.next<std::uint8_t>();
    model.vertices.push_back(vertex);
  }
  for (RawNumbers numbers(std::move(triangles)); !numbers.isAtEnd();) {
    ObjectModel::Triangle triangle{};
    for (std::int32_t& corner : triangle) corner = numbers.next<std::int32_t>();
    model.triangles.push_back(triangle);
  }
  return model;
}

}  // namespace

void insertTruth(const base::SqliteDatabase& database, const RunDescription& run) {
  base::SqliteStatement rate(database, "INSERT INTO motion_rate VALUES (?, ?)");
  for (std::size_t i = 0; i < run.motions.size(); ++i) {
    rate.run(signedIndex(i), run.motions[i].rate);
  }
  base::SqliteStatement of_world(database, "INSERT INTO world_class VALUES (?, ?)");
  for (std::size_t i = 0; i < run.world_classes.size(); ++i) {
    of_world.run(signedIndex(i), run.world_classes[i]);
  }
  base::SqliteStatement credit(database, "INSERT INTO credit VALUES (?, ?, ?, ?, ?)");
  for (const auto& [path, named] : run.credits) {
    credit.run(path, named.author, named.author_in, named.license, named.license_in);
  }
  base::SqliteStatement split(database, "INSERT INTO split VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < run.splits.size(); ++i) {
    split.run(signedIndex(i), run.splits[i].name, run.splits[i].scene_count);
  }
  base::SqliteStatement camera(database,
                               "INSERT INTO camera_model VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.cameras.size(); ++i) {
    if (!run.cameras[i].model) continue;
    const CameraModel& model = *run.cameras[i].model;
    const Intrinsics& k = model.intrinsics();
    camera.run(signedIndex(i), k.fx, k.fy, k.cx, k.cy, model.near(), model.far(),
               distortionModelName(model.distortion().model), coefficientText(model.distortion()),
               model.distortion().cutoff_angle, std::int64_t{run.cameras[i].intrinsics_vary});
  }
  base::SqliteStatement keypoint(database, "INSERT INTO object_keypoint VALUES (?, ?, ?)");
  base::SqliteStatement part(database, "INSERT INTO object_part VALUES (?, ?, ?)");
  base::SqliteStatement line(database, "INSERT INTO object_line VALUES (?, ?, ?, ?)");
  base::SqliteStatement model(database, "INSERT INTO object_model VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.objects.size(); ++i) {
    const RunDescription::Object& object = run.objects[i];
    for (std::size_t k = 0; k < object.keypoint_names.size(); ++k) {
      keypoint.run(signedIndex(i), signedIndex(k), object.keypoint_names[k]);
    }
    for (std::size_t k = 0; k < object.part_names.size(); ++k) {
      part.run(signedIndex(i), signedIndex(k), object.part_names[k]);
    }
    for (std::size_t k = 0; k < object.skeleton.size(); ++k) {
      line.run(signedIndex(i), signedIndex(k), signedIndex(object.skeleton[k][0]),
               signedIndex(object.skeleton[k][1]));
    }
    std::optional<double> diameter;
    std::optional<base::Blob> vertices;
    std::optional<base::Blob> triangles;
    if (object.model) {
      diameter = object.model->diameter;
      vertices = modelVertices(*object.model);
      triangles = modelTriangles(*object.model);
    }
    model.run(signedIndex(i), std::int64_t{object.model_varies}, diameter, vertices, triangles);
  }
}

void readTruth(const base::SqliteDatabase& database, RunDescription& run) {
  base::SqliteStatement credits(database,
                                "SELECT path, author, author_in, license, license_in FROM credit");
  while (credits.step()) {
    run.credits[credits.text(0)] = {credits.text(1), credits.text(2), credits.text(3),
                                    credits.text(4)};
  }
  base::SqliteStatement rates(database, "SELECT motion, rate FROM motion_rate");
  while (rates.step()) {
    const auto index = static_cast<std::size_t>(rates.integer(0));
    if (index < run.motions.size()) run.motions[index].rate = rates.real(1);
  }
  base::SqliteStatement of_world(database, "SELECT name FROM world_class ORDER BY \"index\"");
  while (of_world.step()) run.world_classes.push_back(of_world.text(0));
  base::SqliteStatement splits(database, "SELECT name, scene_count FROM split ORDER BY \"index\"");
  while (splits.step()) run.splits.push_back({splits.text(0), splits.integer(1)});
  base::SqliteStatement cameras(
      database,
      "SELECT camera, fx, fy, cx, cy, near, far, distortion, coefficients, "
      "cutoff_angle, varies FROM camera_model");
  while (cameras.step()) {
    const auto index = static_cast<std::size_t>(cameras.integer(0));
    if (index >= run.cameras.size()) continue;
    RunDescription::Camera& camera = run.cameras[index];
    camera.model = cameraAt(cameras, 1, camera.width, camera.height);
    camera.intrinsics_vary = cameras.integer(10) != 0;
  }
  const auto objectAt = [&](const base::SqliteStatement& row) {
    const auto index = static_cast<std::size_t>(row.integer(0));
    return index < run.objects.size() ? &run.objects[index] : nullptr;
  };
  base::SqliteStatement keypoints(
      database, "SELECT object, name FROM object_keypoint ORDER BY object, sequence");
  while (keypoints.step()) {
    if (auto* const object = objectAt(keypoints)) {
      object->keypoint_names.push_back(keypoints.text(1));
    }
  }
  base::SqliteStatement parts(database,
                              "SELECT object, name FROM object_part ORDER BY object, sequence");
  while (parts.step()) {
    if (auto* const object = objectAt(parts)) object->part_names.push_back(parts.text(1));
  }
  base::SqliteStatement lines(
      database, "SELECT object, first, second FROM object_line ORDER BY object, sequence");
  while (lines.step()) {
    if (auto* const object = objectAt(lines)) {
      object->skeleton.push_back(
          {static_cast<std::size_t>(lines.integer(1)), static_cast<std::size_t>(lines.integer(2))});
    }
  }
  base::SqliteStatement models(
      database, "SELECT object, varies, diameter, vertices, triangles FROM object_model");
  while (models.step()) {
    auto* const object = objectAt(models);
    if (object == nullptr) continue;
    object->model_varies = models.integer(1) != 0;
    if (models.isNull(2)) continue;
    object->model = modelOf(models.real(2), models.blob(3), models.blob(4));
  }
}

}  // namespace synthetic_dataset::output

#include "output/manifest/truth_tables.h"

#include <array>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/json_text.h"
#include "base/yaml_value.h"
#include "output/manifest/mask_bytes.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {

const char* const kTruthTables = R"sql(
  CREATE TABLE credit (path TEXT PRIMARY KEY REFERENCES input (path), author TEXT NOT NULL,
                       author_in TEXT NOT NULL, license TEXT NOT NULL,
                       license_in TEXT NOT NULL) WITHOUT ROWID;
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
)sql";

const std::vector<std::string>& truthTablesOfScenes() {
  static const std::vector<std::string> kTables = {"scene_camera", "scene_frame", "scene_picture",
                                                   "scene_shape", "scene_keypoint"};
  return kTables;
}

namespace {

std::int64_t signedIndex(std::size_t index) { return static_cast<std::int64_t>(index); }

/// Numbers as they lie in memory; the systems that this runs on agree (IEEE 754, lowest byte
/// first).
template <class Number>
void append(const Number& number, std::string& bytes) {
  static_assert(std::is_arithmetic_v<Number>);
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &number, sizeof(Number));
  bytes.append(raw.data(), raw.size());
}

/// Takes numbers from the front of bytes.
class RawNumbers {
 public:
  explicit RawNumbers(std::string bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] bool isAtEnd() const { return at_ == bytes_.size(); }

  template <class Number>
  Number next() {
    if (bytes_.size() - at_ < sizeof(Number)) throw Error("a list in the manifest is damaged");
    Number number{};
    std::memcpy(&number, bytes_.data() + at_, sizeof(Number));
    at_ += sizeof(Number);
    return number;
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

std::string coefficientText(const Distortion& distortion) {
  Value::List numbers;
  for (const double each : coefficientsOf(distortion)) numbers.emplace_back(each);
  return base::jsonText(Value(numbers));
}

/// From nine columns, as both tables of cameras have them; nothing for a camera that cannot be.
std::optional<CameraModel> cameraAt(const SqliteStatement& row, int first, int width, int height) {
  std::vector<double> coefficients;
  const Value list = base::parseYaml(row.text(first + 7), "a camera's coefficients");
  if (list.is<Value::List>()) {
    for (const Value& each : *list.as<Value::List>()) {
      const auto* whole = each.as<std::int64_t>();
      const auto* number = each.as<double>();
      if (whole == nullptr && number == nullptr) throw Error("a camera's coefficients are damaged");
      coefficients.push_back(whole != nullptr ? static_cast<double>(*whole) : *number);
    }
  }
  Distortion distortion = makeDistortion(row.text(first + 6), coefficients);
  distortion.cutoff_angle = row.real(first + 8);
  try {
    const Intrinsics intrinsics{row.real(first), row.real(first + 1), row.real(first + 2),
                                row.real(first + 3)};
    return CameraModel(width, height, intrinsics, row.real(first + 4), row.real(first + 5),
                       distortion);
  } catch (const Error&) {
    return std::nullopt;  // of a size that no image has, say
  }
}

Blob modelVertices(const ObjectModel& model) {
  Blob blob;
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    for (int i = 0; i < 3; ++i) append(vertex.position(i), blob.bytes);
    for (int i = 0; i < 3; ++i) append(vertex.normal(i), blob.bytes);
    for (const std::uint8_t each : vertex.colour) append(each, blob.bytes);
  }
  return blob;
}

Blob modelTriangles(const ObjectModel& model) {
  Blob blob;
  for (const ObjectModel::Triangle& triangle : model.triangles) {
    for (const std::int32_t corner : triangle) append(corner, blob.bytes);
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

const std::array<std::pair<KeypointState, const char*>, 4> kStates = {
    {{KeypointState::kOutside, "outside"},
     {KeypointState::kHiddenByAnother, "hidden by another"},
     {KeypointState::kHiddenByItself, "hidden by itself"},
     {KeypointState::kVisible, "visible"}}};

std::optional<std::string> stateText(const std::optional<KeypointState>& state) {
  for (const auto& [each, text] : kStates) {
    if (state == each) return text;
  }
  return std::nullopt;
}

std::optional<KeypointState> stateOf(const std::string& text) {
  for (const auto& [each, name] : kStates) {
    if (text == name) return each;
  }
  return std::nullopt;
}

Blob pointBytes(const std::vector<Eigen::Vector3d>& points) {
  Blob blob;
  for (const Eigen::Vector3d& point : points) {
    for (int i = 0; i < 3; ++i) append(point(i), blob.bytes);
  }
  return blob;
}

std::optional<Blob> maskBlob(const std::optional<Mask>& mask) {
  return mask ? std::optional(Blob{maskBytes(*mask)}) : std::nullopt;
}

std::optional<Blob> cellBytes(const std::vector<float>& cells) {
  if (cells.empty()) return std::nullopt;
  Blob blob;
  for (const float each : cells) append(each, blob.bytes);
  return blob;
}

}  // namespace

void insertTruth(const SqliteDatabase& database, const RunDescription& run) {
  SqliteStatement credit(database, "INSERT INTO credit VALUES (?, ?, ?, ?, ?)");
  for (const auto& [path, named] : run.credits) {
    credit.run(path, named.author, named.author_in, named.license, named.license_in);
  }
  SqliteStatement split(database, "INSERT INTO split VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < run.splits.size(); ++i) {
    split.run(signedIndex(i), run.splits[i].name, run.splits[i].scene_count);
  }
  SqliteStatement camera(database,
                         "INSERT INTO camera_model VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.cameras.size(); ++i) {
    if (!run.cameras[i].model) continue;
    const CameraModel& model = *run.cameras[i].model;
    const Intrinsics& k = model.intrinsics();
    camera.run(signedIndex(i), k.fx, k.fy, k.cx, k.cy, model.near(), model.far(),
               distortionModelName(model.distortion().model), coefficientText(model.distortion()),
               model.distortion().cutoff_angle, std::int64_t{run.cameras[i].intrinsics_vary});
  }
  SqliteStatement keypoint(database, "INSERT INTO object_keypoint VALUES (?, ?, ?)");
  SqliteStatement line(database, "INSERT INTO object_line VALUES (?, ?, ?, ?)");
  SqliteStatement model(database, "INSERT INTO object_model VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.objects.size(); ++i) {
    const RunDescription::Object& object = run.objects[i];
    for (std::size_t k = 0; k < object.keypoint_names.size(); ++k) {
      keypoint.run(signedIndex(i), signedIndex(k), object.keypoint_names[k]);
    }
    for (std::size_t k = 0; k < object.skeleton.size(); ++k) {
      line.run(signedIndex(i), signedIndex(k), signedIndex(object.skeleton[k][0]),
               signedIndex(object.skeleton[k][1]));
    }
    std::optional<double> diameter;
    std::optional<Blob> vertices;
    std::optional<Blob> triangles;
    if (object.model) {
      diameter = object.model->diameter;
      vertices = modelVertices(*object.model);
      triangles = modelTriangles(*object.model);
    }
    model.run(signedIndex(i), std::int64_t{object.model_varies}, diameter, vertices, triangles);
  }
}

TruthInserter::TruthInserter(const SqliteDatabase& database)
    : camera_(database, "INSERT INTO scene_camera VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      frame_(database, "INSERT INTO scene_frame VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      picture_(database, "INSERT INTO scene_picture VALUES (?, ?, ?, ?)"),
      shape_(database, "INSERT INTO scene_shape VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      keypoint_(database, "INSERT INTO scene_keypoint VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)") {}

void TruthInserter::insert(const SceneFacts& scene, const std::vector<PictureFacts>& pictures) {
  if (scene.camera_model) {
    const CameraModel& model = *scene.camera_model;
    const Intrinsics& k = model.intrinsics();
    camera_.run(scene.index, k.fx, k.fy, k.cx, k.cy, model.near(), model.far(),
                distortionModelName(model.distortion().model), coefficientText(model.distortion()),
                model.distortion().cutoff_angle);
  }
  for (const auto& [frame, X_GF] : scene.frames) {
    const Eigen::Vector3d p = X_GF.translation();
    const Eigen::Quaterniond q(X_GF.linear());
    frame_.run(scene.index, frame, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
  }
  for (const PictureFacts& each : pictures) {
    picture_.run(scene.index, each.name, each.digest, cellBytes(each.cells));
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    insertObject(scene.index, signedIndex(i), scene.objects[i]);
  }
}

void TruthInserter::insertObject(std::int64_t scene, std::int64_t object,
                                 const ObjectFacts& facts) {
  const Eigen::Vector3d& low = facts.cuboid_O.low;
  const Eigen::Vector3d& high = facts.cuboid_O.high;
  shape_.run(scene, object, low.x(), low.y(), low.z(), high.x(), high.y(), high.z(),
             pointBytes(facts.bounding_shape_O), facts.silhouette_in_image,
             maskBlob(facts.silhouette), maskBlob(facts.visible_mask));
  std::int64_t sequence = 0;
  for (const KeypointFacts& each : facts.keypoints) {
    const std::optional<double> u = each.pixel ? std::optional(each.pixel->x()) : std::nullopt;
    const std::optional<double> v = each.pixel ? std::optional(each.pixel->y()) : std::nullopt;
    keypoint_.run(scene, object, sequence++, each.p_O.x(), each.p_O.y(), each.p_O.z(), u, v,
                  stateText(each.state));
  }
}

void readTruth(const SqliteDatabase& database, RunDescription& run) {
  SqliteStatement credits(database,
                          "SELECT path, author, author_in, license, license_in FROM credit");
  while (credits.step()) {
    run.credits[credits.text(0)] = {credits.text(1), credits.text(2), credits.text(3),
                                    credits.text(4)};
  }
  SqliteStatement splits(database, "SELECT name, scene_count FROM split ORDER BY \"index\"");
  while (splits.step()) run.splits.push_back({splits.text(0), splits.integer(1)});
  SqliteStatement cameras(database,
                          "SELECT camera, fx, fy, cx, cy, near, far, distortion, coefficients, "
                          "cutoff_angle, varies FROM camera_model");
  while (cameras.step()) {
    const auto index = static_cast<std::size_t>(cameras.integer(0));
    if (index >= run.cameras.size()) continue;
    RunDescription::Camera& camera = run.cameras[index];
    camera.model = cameraAt(cameras, 1, camera.width, camera.height);
    camera.intrinsics_vary = cameras.integer(10) != 0;
  }
  const auto objectAt = [&](const SqliteStatement& row) {
    const auto index = static_cast<std::size_t>(row.integer(0));
    return index < run.objects.size() ? &run.objects[index] : nullptr;
  };
  SqliteStatement keypoints(database,
                            "SELECT object, name FROM object_keypoint ORDER BY object, sequence");
  while (keypoints.step()) {
    if (auto* const object = objectAt(keypoints)) {
      object->keypoint_names.push_back(keypoints.text(1));
    }
  }
  SqliteStatement lines(database,
                        "SELECT object, first, second FROM object_line ORDER BY object, sequence");
  while (lines.step()) {
    if (auto* const object = objectAt(lines)) {
      object->skeleton.push_back(
          {static_cast<std::size_t>(lines.integer(1)), static_cast<std::size_t>(lines.integer(2))});
    }
  }
  SqliteStatement models(database,
                         "SELECT object, varies, diameter, vertices, triangles FROM object_model");
  while (models.step()) {
    auto* const object = objectAt(models);
    if (object == nullptr) continue;
    object->model_varies = models.integer(1) != 0;
    if (models.isNull(2)) continue;
    object->model = modelOf(models.real(2), models.blob(3), models.blob(4));
  }
}

namespace {

void readScenePictures(const SqliteDatabase& database, SceneFacts& scene) {
  SqliteStatement rows(database,
                       "SELECT picture, digest, cells FROM scene_picture WHERE scene = ?");
  for (rows.start(scene.index); rows.step();) {
    PictureFacts facts{rows.text(0), rows.text(1), {}};
    for (RawNumbers numbers(rows.blob(2)); !numbers.isAtEnd();) {
      facts.cells.push_back(numbers.next<float>());
    }
    scene.known_pictures.push_back(std::move(facts));
  }
}

void readShapes(const SqliteDatabase& database, SceneFacts& scene) {
  const cv::Size size(scene.width, scene.height);
  SqliteStatement rows(database,
                       "SELECT object, low_x, low_y, low_z, high_x, high_y, high_z, "
                       "bounding_shape, silhouette_in_image, silhouette, visible_mask FROM "
                       "scene_shape WHERE scene = ? ORDER BY object");
  for (rows.start(scene.index); rows.step();) {
    const auto index = static_cast<std::size_t>(rows.integer(0));
    if (index >= scene.objects.size()) continue;
    ObjectFacts& facts = scene.objects[index];
    facts.cuboid_O = {{rows.real(1), rows.real(2), rows.real(3)},
                      {rows.real(4), rows.real(5), rows.real(6)}};
    for (RawNumbers numbers(rows.blob(7)); !numbers.isAtEnd();) {
      const auto x = numbers.next<double>();
      const auto y = numbers.next<double>();
      facts.bounding_shape_O.emplace_back(x, y, numbers.next<double>());
    }
    if (!rows.isNull(8)) facts.silhouette_in_image = rows.integer(8);
    if (!rows.isNull(9)) facts.silhouette = maskOfBytes(rows.blob(9), size);
    if (!rows.isNull(10)) facts.visible_mask = maskOfBytes(rows.blob(10), size);
  }
}

void readKeypoints(const SqliteDatabase& database, SceneFacts& scene) {
  SqliteStatement rows(database,
                       "SELECT object, x, y, z, u, v, state FROM scene_keypoint WHERE scene = ? "
                       "ORDER BY object, sequence");
  for (rows.start(scene.index); rows.step();) {
    const auto index = static_cast<std::size_t>(rows.integer(0));
    if (index >= scene.objects.size()) continue;
    KeypointFacts facts;
    facts.p_O = {rows.real(1), rows.real(2), rows.real(3)};
    if (!rows.isNull(4)) facts.pixel = Eigen::Vector2d(rows.real(4), rows.real(5));
    facts.state = stateOf(rows.text(6));
    scene.objects[index].keypoints.push_back(facts);
  }
}

}  // namespace

void readTruth(const SqliteDatabase& database, SceneFacts& scene) {
  SqliteStatement camera(database,
                         "SELECT fx, fy, cx, cy, near, far, distortion, coefficients, "
                         "cutoff_angle FROM scene_camera WHERE scene = ?");
  camera.start(scene.index);
  if (camera.step()) scene.camera_model = cameraAt(camera, 0, scene.width, scene.height);
  SqliteStatement frames(database,
                         "SELECT frame, x, y, z, qx, qy, qz, qw FROM scene_frame WHERE scene = ?");
  for (frames.start(scene.index); frames.step();) {
    scene.frames[frames.text(0)] = makePose(
        {frames.real(1), frames.real(2), frames.real(3)},
        Eigen::Quaterniond(frames.real(7), frames.real(4), frames.real(5), frames.real(6)));
  }
  readScenePictures(database, scene);
  readShapes(database, scene);
  readKeypoints(database, scene);
}

}  // namespace synthetic_dataset::output

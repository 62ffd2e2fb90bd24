/// Writes and reads the truth about scenes: rows of the truth tables.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <opencv2/core.hpp>

#include "output/manifest/camera_columns.h"
#include "output/manifest/mask_bytes.h"
#include "output/manifest/raw_numbers.h"
#include "output/manifest/truth_tables.h"

namespace synthetic_dataset::output {
namespace {

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

std::optional<KeypointState> keypointStateOf(const std::string& text) {
  for (const auto& [each, name] : kStates) {
    if (text == name) return each;
  }
  return std::nullopt;
}

base::Blob pointBytes(const std::vector<Eigen::Vector3d>& points) {
  base::Blob blob;
  for (const Eigen::Vector3d& point : points) {
    for (int i = 0; i < 3; ++i) appendRaw(point(i), blob.bytes);
  }
  return blob;
}

std::optional<base::Blob> maskBlob(const std::optional<Mask>& mask) {
  return mask ? std::optional(base::Blob{maskBytes(*mask)}) : std::nullopt;
}

std::optional<base::Blob> cellBytes(const std::vector<float>& cells) {
  if (cells.empty()) return std::nullopt;
  base::Blob blob;
  for (const float each : cells) appendRaw(each, blob.bytes);
  return blob;
}

/// The masks of a map's non-zero values, by value.
std::map<std::uint16_t, Mask> masksOfValues(const cv::Mat& map) {
  const cv::Mat_<std::uint16_t> values = map;
  std::map<std::uint16_t, Mask> masks;
  for (const std::uint16_t value : std::set<std::uint16_t>(values.begin(), values.end())) {
    if (value != 0) masks.emplace(value, Mask(map == static_cast<double>(value)));
  }
  return masks;
}

}  // namespace

TruthInserter::TruthInserter(const base::SqliteDatabase& database)
    : camera_(database, "INSERT INTO scene_camera VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      frame_(database, "INSERT INTO scene_frame VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      picture_(database, "INSERT INTO scene_picture VALUES (?, ?, ?, ?)"),
      link_map_(database, "INSERT INTO scene_link_map VALUES (?, ?, ?, ?)"),
      shape_(database, "INSERT INTO scene_shape VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      keypoint_(database, "INSERT INTO scene_keypoint VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      alignment_(database, "INSERT INTO scene_alignment VALUES (?, ?)"),
      object_alignment_(database, "INSERT INTO object_alignment VALUES (?, ?, ?)"),
      cover_(database, "INSERT INTO scene_cover VALUES (?, ?, ?)"),
      object_cover_(database, "INSERT INTO object_cover VALUES (?, ?, ?, ?)") {}

void TruthInserter::insertPictureFit(const SceneFacts& scene) {
  if (scene.alignment) alignment_.run(scene.index, *scene.alignment);
  if (scene.cover) cover_.run(scene.index, scene.cover->unmeasured, scene.cover->covered);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::optional<double>& of_object = scene.objects[i].alignment;
    if (of_object) object_alignment_.run(scene.index, signedIndex(i), *of_object);
    const std::optional<CoverFacts>& cover = scene.objects[i].cover;
    if (cover) object_cover_.run(scene.index, signedIndex(i), cover->unmeasured, cover->covered);
  }
}

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
  for (const auto& [name, map] : scene.link_maps) {
    for (const auto& [value, mask] : masksOfValues(map)) {
      link_map_.run(scene.index, name, std::int64_t{value}, base::Blob{maskBytes(mask)});
    }
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    insertObject(scene.index, signedIndex(i), scene.objects[i]);
  }
  insertPictureFit(scene);
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
    std::optional<double> u;
    std::optional<double> v;
    if (each.pixel) u = each.pixel->x();
    if (each.pixel) v = each.pixel->y();
    keypoint_.run(scene, object, sequence++, each.p_O.x(), each.p_O.y(), each.p_O.z(), u, v,
                  stateText(each.state));
  }
}

namespace {

void readScenePictures(const base::SqliteDatabase& database, SceneFacts& scene) {
  base::SqliteStatement rows(database,
                             "SELECT picture, digest, cells FROM scene_picture WHERE scene = ?");
  for (rows.start(scene.index); rows.step();) {
    PictureFacts facts{rows.text(0), rows.text(1), {}};
    for (RawNumbers numbers(rows.blob(2)); !numbers.isAtEnd();) {
      facts.cells.push_back(numbers.next<float>());
    }
    scene.known_pictures.push_back(std::move(facts));
  }
}

void readLinkMaps(const base::SqliteDatabase& database, SceneFacts& scene) {
  const cv::Size size(scene.width, scene.height);
  base::SqliteStatement rows(database,
                             "SELECT map, value, pixels FROM scene_link_map WHERE scene = ?");
  for (rows.start(scene.index); rows.step();) {
    const Mask mask = maskOfBytes(rows.blob(2), size);
    cv::Mat& map = scene.link_maps[rows.text(0)];
    if (map.empty()) map = cv::Mat(size, CV_16UC1, cv::Scalar(0));
    if (!mask.empty()) {
      map(mask.bounds()).setTo(static_cast<double>(rows.integer(1)), mask.pixels());
    }
  }
}

void readShapes(const base::SqliteDatabase& database, SceneFacts& scene) {
  const cv::Size size(scene.width, scene.height);
  base::SqliteStatement rows(database,
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

void readKeypoints(const base::SqliteDatabase& database, SceneFacts& scene) {
  base::SqliteStatement rows(
      database,
      "SELECT object, x, y, z, u, v, state FROM scene_keypoint WHERE scene = ? "
      "ORDER BY object, sequence");
  for (rows.start(scene.index); rows.step();) {
    const auto index = static_cast<std::size_t>(rows.integer(0));
    if (index >= scene.objects.size()) continue;
    KeypointFacts facts;
    facts.p_O = {rows.real(1), rows.real(2), rows.real(3)};
    if (!rows.isNull(4)) facts.pixel = Eigen::Vector2d(rows.real(4), rows.real(5));
    facts.state = keypointStateOf(rows.text(6));
    scene.objects[index].keypoints.push_back(facts);
  }
}

}  // namespace

void readTruth(const base::SqliteDatabase& database, SceneFacts& scene) {
  base::SqliteStatement camera(database,
                               "SELECT fx, fy, cx, cy, near, far, distortion, coefficients, "
                               "cutoff_angle FROM scene_camera WHERE scene = ?");
  camera.start(scene.index);
  if (camera.step()) scene.camera_model = cameraAt(camera, 0, scene.width, scene.height);
  base::SqliteStatement frames(
      database, "SELECT frame, x, y, z, qx, qy, qz, qw FROM scene_frame WHERE scene = ?");
  for (frames.start(scene.index); frames.step();) {
    scene.frames[frames.text(0)] = makePose(
        {frames.real(1), frames.real(2), frames.real(3)},
        Eigen::Quaterniond(frames.real(7), frames.real(4), frames.real(5), frames.real(6)));
  }
  readScenePictures(database, scene);
  readLinkMaps(database, scene);
  readShapes(database, scene);
  readKeypoints(database, scene);
}

}  // namespace synthetic_dataset::output

#include <nlohmann/json.hpp>
#include <ostream>

#include <pluginlib/class_list_macros.hpp>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::test {
namespace {

using Json = nlohmann::json;

template <class Vector>
Json numbers(const Vector& vector) {
  return Json(std::vector<double>(vector.data(), vector.data() + vector.size()));
}

Json points(const std::vector<Eigen::Vector3d>& list) {
  Json json = Json::array();
  for (const Eigen::Vector3d& point : list) json.push_back(numbers(point));
  return json;
}

/// Four rows of four.
Json matrix(const Pose& pose) {
  Json rows = Json::array();
  for (int i = 0; i < 4; ++i) {
    const Eigen::RowVector4d row = pose.matrix().row(i);
    rows.push_back(numbers(row));
  }
  return rows;
}

Json box(const std::optional<Box>& given) {
  if (!given) return nullptr;
  return {given->left, given->top, given->right, given->bottom};
}

const char* nameOf(KeypointState state) {
  switch (state) {
    case KeypointState::kOutside:
      return "outside";
    case KeypointState::kHiddenByAnother:
      return "hidden_by_another";
    case KeypointState::kHiddenByItself:
      return "hidden_by_itself";
    case KeypointState::kVisible:
      return "visible";
  }
  return "";
}

Json keypoint(const Keypoint& given) {
  Json json;
  json["pixel"] = given.pixel ? numbers(*given.pixel) : Json(nullptr);
  json["depth"] = given.depth;
  json["state"] = nameOf(given.state());
  return json;
}

Json camera(const CameraModel& model) {
  const Intrinsics& k = model.intrinsics();
  return {{"width", model.width()},
          {"height", model.height()},
          {"K", {{k.fx, 0.0, k.cx}, {0.0, k.fy, k.cy}, {0.0, 0.0, 1.0}}},
          {"distortion_model", static_cast<int>(model.distortion().model)},
          {"D", model.distortion().coefficients},
          {"near", model.near()},
          {"far", model.far()}};
}

Json cloud(const Cloud& given) {
  Json points = Json::array();
  for (const CloudPoint& each : given.points) {
    for (const float number : {each.position_at_stamp_S.x(), each.position_at_stamp_S.y(),
                               each.position_at_stamp_S.z(), each.intensity}) {
      points.push_back(number);
    }
    for (const std::uint32_t number : std::initializer_list<std::uint32_t>{
             each.ring, each.column, each.instance, each.class_number, each.world_class}) {
      points.push_back(number);
    }
  }
  return {{"X_GS", matrix(given.X_GS)}, {"points", std::move(points)}};
}

Json object(const SceneObject& given, const CameraModel& model) {
  Json keypoints = Json::array();
  for (const Keypoint& each : given.keypoints) keypoints.push_back(keypoint(each));
  const Cuboid& cuboid = given.cuboid_O;
  return {{"name", given.name},
          {"class_name", given.class_name},
          {"class_id", given.class_id},
          {"id", given.id},
          {"instance", given.instance},
          {"X_GO", matrix(*given.X_GO)},
          {"X_CO", matrix(*given.X_CO)},
          {"keypoints_O", points(given.keypoints_O)},
          {"bounding_shape_O", points(given.bounding_shape_O)},
          {"keypoints", keypoints},
          {"cuboid_O", {numbers(cuboid.low), numbers(cuboid.high)}},
          {"loose_box", box(given.loose_box)},
          {"in_view", given.inView(model)},
          {"silhouette_box", box(given.silhouette_box())},
          {"visible_box", box(given.visibleBox())},
          {"silhouette_pixels", given.pixels.silhouette()},
          {"silhouette_pixels_in_image", given.pixels.silhouette_in_image()},
          {"visible_pixels", given.pixels.visible()},
          {"visibility", given.visibility()},
          {"truncation", given.truncation()},
          {"dropped", given.dropped},
          {"labelled", given.labelled()}};
}

}  // namespace

/// All that a scene knows, free of any format: `N.json` and the pictures `N.image.png`,
/// `N.instances.png`, `N.classes.png`, `N.depth.tiff`, `N.silhouette_I.png`, `N.visible_I.png`,
/// where I is the object's instance; `N.cloud.json` of a lidar; `dataset.json`. What the tests of
/// loaders compare with.
class TruthWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& /*parameters*/, const DatasetInfo& dataset) override {
    dataset_ = dataset;
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.silhouettes = true;
    requirements.visible_masks = true;
    requirements.visibility = true;
    requirements.keypoint_states = true;
    requirements.class_map = true;
    requirements.depth = true;
    requirements.clouds = !dataset_.lidars.empty();
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    Json json{{"index", scene.index},
              {"name", scene.name},
              {"camera_name", scene.camera_name},
              {"camera_index", scene.camera_index},
              {"instant", scene.instant},
              {"split", scene.split},
              {"stamp_ns", scene.stamp.count()},
              {"camera", camera(scene.camera)},
              {"X_GC", matrix(scene.X_GC)}};
    json["objects"] = Json::array();
    output.addImage(scene.name + ".image.png", scene.image);
    output.addImage(scene.name + ".instances.png", scene.instance_map());
    output.addImage(scene.name + ".classes.png", scene.class_map());
    output.addImage(scene.name + ".depth.tiff", scene.depth());
    for (const SceneObject& each : scene.objects) {
      json["objects"].push_back(object(each, scene.camera));
      const std::string number = std::to_string(each.instance);
      output.addMask(scene.name + ".silhouette_" + number + ".png", each.silhouette());
      output.addMask(scene.name + ".visible_" + number + ".png", each.visible_mask());
    }
    output.addText(scene.name + ".json", json.dump());
    if (!dataset_.lidars.empty()) {
      output.addText(scene.name + ".cloud.json", cloud(*scene.clouds().front()).dump());
    }
    output.addRecord("scenes", scene.name);
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    output.addFile("dataset.json", [&](std::ostream& stream) {
      Json json{{"global_frame", dataset_.global_frame}};
      for (const char* list : {"scenes", "classes", "splits", "objects", "cameras"}) {
        json[list] = Json::array();
      }
      records.forEach(
          "scenes", [&](std::int64_t, const std::string& name) { json["scenes"].push_back(name); });
      for (const ClassInfo& each : dataset_.classes) {
        json["classes"].push_back({{"id", each.id}, {"name", each.name}});
      }
      for (const SplitInfo& split : dataset_.splits) {
        json["splits"].push_back({{"name", split.name}, {"scene_count", split.scene_count}});
      }
      for (const CameraDescription& each : dataset_.cameras) {
        json["cameras"].push_back({{"name", each.name}, {"frame", each.frame}});
      }
      for (std::size_t i = 0; i < dataset_.objects.size(); ++i) {
        json["objects"].push_back(describeObject(i));
      }
      stream << json.dump();
    });
  }

  [[nodiscard]] Json describeObject(std::size_t index) const {
    const ObjectInfo& info = dataset_.objects[index];
    const ObjectModel model = dataset_.model(index);
    Json json{{"name", info.name},
              {"class_name", info.class_name},
              {"class_id", info.class_id},
              {"id", info.id},
              {"keypoint_names", info.keypoint_names},
              {"skeleton", info.skeleton},
              {"diameter", model.diameter},
              {"triangles", model.triangles}};
    json["vertices"] = Json::array();
    for (const ObjectModel::Vertex& vertex : model.vertices) {
      json["vertices"].push_back(numbers(vertex.position));
    }
    return json;
  }

  DatasetInfo dataset_;
};

}  // namespace synthetic_dataset::test

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::test::TruthWriter, synthetic_dataset::LabelWriter)

#include "synthetic_dataset/hand_made.h"

#include <algorithm>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

const cv::Size kImageSize(640, 480);

Mask maskOf(const cv::Rect& pixels) {
  cv::Mat image(kImageSize, CV_8UC1, cv::Scalar(0));
  image(pixels).setTo(255);
  return Mask(image);
}

}  // namespace

CameraModel handMadeCamera() {
  return {kImageSize.width, kImageSize.height, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0};
}

SceneObject handMadeObject(const std::string& name) {
  SceneObject object;
  object.name = name;
  object.class_name = object.class_text = name + "_class";
  object.id = name + "_id";
  object.X_GO->translation() = Eigen::Vector3d(0.0, 0.0, 10.0);
  object.X_CO = object.X_GO;
  object.silhouette = Mask(kImageSize);
  object.silhouette_box = std::nullopt;
  object.pixels.silhouette = object.pixels.silhouette_in_image = 0;
  return hidden(object);
}

SceneObject handMadeObject(const std::string& name, const cv::Rect& pixels) {
  SceneObject object = handMadeObject(name);
  object.cuboid_O = {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  const cv::Rect visible = pixels & cv::Rect({}, kImageSize);
  object.silhouette = maskOf(visible);
  object.visible_mask = maskOf(visible);
  object.loose_box = boxAround(pixels);
  object.silhouette_box = object.loose_box;
  object.pixels.silhouette = pixels.area();
  object.pixels.silhouette_in_image = object.pixels.visible = visible.area();
  return object;
}

SceneObject hidden(SceneObject object) {
  object.visible_mask = Mask(kImageSize);
  object.pixels.visible = 0;
  return object;
}

Scene handMadeScene(std::int64_t index, std::vector<SceneObject> objects) {
  Scene scene(handMadeCamera());
  scene.index = scene.instant = index;
  scene.name = sceneNumber(index);
  scene.camera_name = "camera";
  scene.stamp = Stamp{index};
  scene.image = cv::Mat(kImageSize, CV_8UC3, cv::Scalar::all(50));
  cv::Mat instance_map(kImageSize, CV_16UC1, cv::Scalar(0));
  cv::Mat class_map = instance_map.clone();
  cv::Mat depth(kImageSize, CV_32FC1, cv::Scalar(0));
  for (SceneObject& each : objects) {
    each.instance = static_cast<int>(scene.objects.size()) + 1;
    const cv::Mat visible = each.visible_mask().whole();
    instance_map.setTo(each.instance, visible);
    class_map.setTo(each.class_id + 1, visible);
    if (each.X_CO) depth.setTo(each.X_CO->translation().z(), visible);
    scene.objects.push_back(std::move(each));
  }
  scene.instance_map = instance_map;
  scene.class_map = class_map;
  scene.world_map = cv::Mat(kImageSize, CV_16UC1, cv::Scalar(0));
  scene.part_map = cv::Mat(kImageSize, CV_16UC1, cv::Scalar(0));
  scene.depth = depth;
  scene.setTransforms([](const std::string& target, const std::string& source) -> Pose {
    if (target == source) return Pose::Identity();
    throw Error("no transform from " + source + " to " + target);
  });
  return scene;
}

DatasetInfo handMadeDataset(const std::vector<SceneObject>& objects) {
  DatasetInfo dataset;
  dataset.global_frame = "map";
  dataset.cameras = {{"camera", "camera/optical_link", handMadeCamera()}};
  dataset.scene_count = 1;
  dataset.motions = {{"0", 0, dataset.scene_count, 0.0}};
  for (const SceneObject& object : objects) {
    ObjectInfo& info = dataset.objects.emplace_back();
    info.name = object.name;
    info.class_name = object.class_name;
    info.id = object.id;
    info.class_id = object.class_id;
    info.keypoint_count = object.keypoints_O.size();
    for (std::size_t i = 0; i < info.keypoint_count; ++i) {
      info.keypoint_names.push_back(std::to_string(i));
    }
    std::vector<ClassInfo>& classes = dataset.classes;
    const auto at =
        std::lower_bound(classes.begin(), classes.end(), object.class_id,
                         [](const ClassInfo& known, int class_id) { return known.id < class_id; });
    if (at == classes.end() || at->id != object.class_id) {
      classes.insert(at, {object.class_id, object.class_name});
    }
  }
  return dataset;
}

}  // namespace v2
}  // namespace synthetic_dataset

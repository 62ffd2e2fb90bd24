#include "plugins/plugin_harness.h"

#include <memory>
#include <utility>

#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

const cv::Size kImageSize(640, 480);

}  // namespace

void PluginTest::SetUpTestSuite() { test::preparePluginEnvironment(); }

output::WriterHost& PluginTest::load(const Value::Map& parameters) {
  parameters_ = Parameters(parameters, "w");
  host_ = std::make_unique<output::WriterHost>(
      std::vector<output::WriterOptions>{{"w", type_, folder(), parameters_}}, dataset_,
      std::vector<std::string>{test::pluginXml(), test::examplePluginXml()});
  return *host_;
}

Scene PluginTest::scene(std::int64_t index, std::vector<SceneObject> objects) {
  Scene scene(camera());
  scene.index = index;
  scene.instant = index;
  scene.name = sceneNumber(index);
  scene.camera_name = "camera";
  scene.stamp = Stamp{index};
  scene.image = cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(50));
  cv::Mat instance_map(480, 640, CV_16UC1, cv::Scalar(0));
  cv::Mat class_map(480, 640, CV_16UC1, cv::Scalar(0));
  cv::Mat depth(480, 640, CV_32FC1, cv::Scalar(0));
  for (SceneObject& each : objects) {
    each.instance = static_cast<int>(scene.objects.size()) + 1;
    const cv::Mat visible = each.visible_mask().whole();
    instance_map.setTo(each.instance, visible);
    class_map.setTo(each.class_id + 1, visible);
    depth.setTo(each.X_CO->translation().z(), visible);
    scene.objects.push_back(std::move(each));
  }
  scene.instance_map = instance_map;
  scene.class_map = class_map;
  scene.world_map = cv::Mat(480, 640, CV_16UC1, cv::Scalar(0));
  scene.part_map = cv::Mat(480, 640, CV_16UC1, cv::Scalar(0));
  scene.depth = depth;
  scene.setTransforms([](const std::string& target, const std::string& source) -> Pose {
    if (target == source) return Pose::Identity();
    throw Error("no transform from " + source + " to " + target);
  });
  return scene;
}

void PluginTest::addLidar() { dataset_.lidars.push_back({"top", "top/lidar_link"}); }

Scene PluginTest::withCloud(Scene scene) {
  Cloud cloud;
  cloud.columns = 1 + 2 * static_cast<int>(scene.objects.size());
  cloud.rings = 1;
  const auto add = [&](const SceneObject* object) {
    CloudPoint& point = cloud.points.emplace_back();
    point.column = static_cast<std::uint16_t>(cloud.points.size() - 1);
    const auto along = static_cast<float>(point.column);
    point.position_S = {1.5F, along, 0.5F};
    point.position_at_stamp_S = {1.25F, along, 0.5F};
    point.intensity = 0.5F;
    point.time = 1000 * point.column;
    if (object == nullptr) return;
    point.instance = static_cast<std::uint16_t>(object->instance);
    point.class_number = static_cast<std::uint16_t>(object->class_id + 1);
  };
  add(nullptr);
  for (const SceneObject& each : scene.objects) {
    add(&each);
    add(&each);
  }
  cloud.points_of_objects.assign(scene.objects.size(), 2);
  scene.clouds = Clouds{std::make_shared<const Cloud>(std::move(cloud))};
  scene.setTransforms([](const std::string&, const std::string&) { return Pose::Identity(); });
  return scene;
}

std::vector<Scene> PluginTest::ofTwoCamerasAndSplits(
    const std::function<Scene(std::int64_t)>& scene) {
  dataset_.cameras = {{"left", "left_link", camera()}, {"right", "right_link", camera()}};
  dataset_.splits = {{"train", 2}, {"test", 2}};
  std::vector<Scene> scenes;
  for (std::int64_t i = 0; i < 4; ++i) {
    scenes.push_back(scene(i));
    Scene& made = scenes.back();
    made.camera_index = static_cast<std::size_t>(i % 2);
    made.camera_name = dataset_.cameras[made.camera_index].name;
    made.instant = i / 2;
    made.stamp = Stamp(std::chrono::seconds(1 + made.instant));
    made.name = made.camera_name + "/" + sceneNumber(made.instant);
    made.split = made.instant == 0 ? "train" : "test";
  }
  return scenes;
}

CameraModel PluginTest::camera() { return {640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0}; }

Scene PluginTest::zoomed(Scene scene, double focal_length) {
  scene.camera = CameraModel(640, 480, {focal_length, focal_length, 320.0, 240.0}, 0.05, 100.0);
  return scene;
}

SceneObject PluginTest::object(const std::string& name) {
  SceneObject object;
  object.name = name;
  object.class_name = object.class_text = name + "_class";
  object.id = name + "_id";
  object.X_GO->translation() = Eigen::Vector3d(0.0, 0.0, 10.0);
  object.X_CO = object.X_GO;
  object.in_view = true;
  object.silhouette = Mask(kImageSize);
  object.silhouette_box = std::nullopt;
  object.pixels.silhouette = object.pixels.silhouette_in_image = 0;
  object.truncation = 0.0;
  return hidden(object);
}

SceneObject PluginTest::hidden(SceneObject object) {
  object.visible_mask = Mask(kImageSize);
  object.visible_box = std::nullopt;
  object.pixels.visible = 0;
  object.visibility = 0.0;
  return object;
}

PixelCounts PluginTest::counts(std::int64_t silhouette, std::int64_t in_image,
                               std::int64_t visible) {
  PixelCounts pixels;
  pixels.silhouette = silhouette;
  pixels.silhouette_in_image = in_image;
  pixels.visible = visible;
  return pixels;
}

Mask PluginTest::painted(const Mask& mask, const cv::Rect& pixels, bool on) {
  cv::Mat image = mask.whole();
  image(pixels).setTo(on ? 255 : 0);
  return Mask(image);
}

Keypoint PluginTest::keypoint(const std::optional<Eigen::Vector2d>& pixel, double depth,
                              KeypointState state) {
  Keypoint keypoint;
  keypoint.pixel = pixel;
  keypoint.depth = depth;
  keypoint.state = state;
  return keypoint;
}

SceneObject PluginTest::seen(const std::string& name, const cv::Rect& pixels) {
  SceneObject object = PluginTest::object(name);
  object.cuboid_O = {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  const cv::Rect visible = pixels & cv::Rect(0, 0, 640, 480);
  object.silhouette = painted(object.silhouette(), visible, true);
  object.visible_mask = painted(object.visible_mask(), visible, true);
  const auto edges = [](const cv::Rect& r) {
    return Box{r.x - 0.5, r.y - 0.5, r.br().x - 0.5, r.br().y - 0.5};
  };
  object.loose_box = edges(pixels);
  object.silhouette_box = object.loose_box;
  if (!visible.empty()) object.visible_box = edges(visible);
  object.pixels = counts(pixels.area(), visible.area(), visible.area());
  object.visibility = static_cast<double>(visible.area()) / pixels.area();
  object.truncation = 1.0 - object.visibility();
  return object;
}

PluginTest::PluginTest(std::string type) : type_(std::move(type)) {
  dataset_.global_frame = "map";
  dataset_.cameras = {{"camera", "camera/optical_link", camera()}};
}

std::map<std::string, std::string> PluginTest::filesOf(const Scene& scene) const {
  std::map<std::string, std::string> files;
  for (const output::OutputFile& file : host_->writeScene(scene).files.files) {
    std::string content = file.text;
    if (file.pixels.data == scene.image.data) content = "<image>";
    for (const SceneObject& object : scene.objects) {
      const uchar* pixels = file.mask.pixels().data;
      if (pixels == nullptr) continue;
      if (pixels == object.silhouette().pixels().data) content = "<silhouette " + object.name + ">";
      if (pixels == object.visible_mask().pixels().data) content = "<visible " + object.name + ">";
    }
    files[file.path.substr(folder().size())] = content;
  }
  return files;
}

cv::Mat PluginTest::pictureOf(const Scene& scene, const std::string& path) const {
  for (const output::OutputFile& file : host_->writeScene(scene).files.files) {
    if (file.path != folder() + path) continue;
    return file.mask.imageSize().empty() ? file.pixels : file.mask.whole();
  }
  return {};
}

void PluginTest::runAll(const std::vector<Scene>& scenes) const {
  output::StoreOptions options;
  options.folder = folder_.path().string();
  output::DatasetStore store(options, host_->storeWriters());
  for (const Scene& each : scenes) {
    store.commitScene({each.index, each.stamp}, host_->writeScene(each).files);
  }
  host_->finalize(store);
}

}  // namespace synthetic_dataset

#include "plugins/plugin_harness.h"

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "writers/plugin_environment.h"

namespace synthetic_dataset {

void PluginTest::SetUpTestSuite() { test::preparePluginEnvironment(); }

writers::WriterHost& PluginTest::load(const Value::Map& parameters) {
  parameters_ = Parameters(parameters, "w");
  host_ = std::make_unique<writers::WriterHost>(
      std::vector<writers::WriterOptions>{{"w", type_, folder(), parameters_}}, dataset_,
      std::vector<std::string>{test::pluginXml()});
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
  scene.instance_map = cv::Mat(480, 640, CV_16UC1, cv::Scalar(0));
  scene.class_map = cv::Mat(480, 640, CV_16UC1, cv::Scalar(0));
  scene.depth = cv::Mat(480, 640, CV_32FC1, cv::Scalar(0));
  for (SceneObject& each : objects) {
    each.instance = static_cast<int>(scene.objects.size()) + 1;
    scene.instance_map.setTo(each.instance, each.visible_mask);
    scene.class_map.setTo(each.class_id + 1, each.visible_mask);
    scene.depth.setTo(each.X_CO.translation().z(), each.visible_mask);
    scene.objects.push_back(std::move(each));
  }
  scene.lookup = [](const std::string& target, const std::string& source) -> Pose {
    throw Error("no transform from " + source + " to " + target);
  };
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
  object.X_GO.translation() = Eigen::Vector3d(0.0, 0.0, 10.0);
  object.X_CO = object.X_GO;
  object.in_view = true;
  object.silhouette = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  object.visible_mask = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  return object;
}

SceneObject PluginTest::seen(const std::string& name, const cv::Rect& pixels) {
  SceneObject object = PluginTest::object(name);
  object.cuboid_O = {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  const cv::Rect visible = pixels & cv::Rect(0, 0, 640, 480);
  object.silhouette(visible).setTo(255);
  object.visible_mask(visible).setTo(255);
  const auto edges = [](const cv::Rect& r) {
    return Box{r.x - 0.5, r.y - 0.5, r.br().x - 0.5, r.br().y - 0.5};
  };
  object.loose_box = object.silhouette_box = edges(pixels);
  if (!visible.empty()) object.visible_box = edges(visible);
  object.pixels = {pixels.area(), visible.area(), visible.area()};
  object.visibility = static_cast<double>(visible.area()) / pixels.area();
  object.truncation = 1.0 - object.visibility;
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
      if (file.pixels.empty()) continue;
      if (file.pixels.data == object.silhouette.data) content = "<silhouette " + object.name + ">";
      if (file.pixels.data == object.visible_mask.data) content = "<visible " + object.name + ">";
    }
    files[file.path.substr(folder().size())] = content;
  }
  return files;
}

cv::Mat PluginTest::pictureOf(const Scene& scene, const std::string& path) const {
  for (const output::OutputFile& file : host_->writeScene(scene).files.files) {
    if (file.path == folder() + path) return file.pixels;
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

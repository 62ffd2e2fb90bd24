#include "plugins/plugin_harness.h"

#include <memory>
#include <utility>

#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {

void PluginTest::SetUpTestSuite() { test::preparePluginEnvironment(); }

output::WriterHost& PluginTest::load(const Value::Map& parameters) {
  parameters_ = Parameters(parameters, "w");
  host_ = std::make_unique<output::WriterHost>(
      std::vector<output::WriterOptions>{{"w", type_, folder(), parameters_}}, dataset_,
      std::vector<std::string>{test::pluginXml(), test::examplePluginXml()});
  return *host_;
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

Scene PluginTest::zoomed(Scene scene, double focal_length) {
  scene.camera = CameraModel(640, 480, {focal_length, focal_length, 320.0, 240.0}, 0.05, 100.0);
  return scene;
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

PluginTest::PluginTest(std::string type) : dataset_(handMadeDataset({})), type_(std::move(type)) {
  // Each test states how many scenes there are, and of which motions.
  dataset_.scene_count = 0;
  dataset_.motions.clear();
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

#include "plugins/plugin_harness.h"

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "writers/plugin_environment.h"

namespace synthetic_dataset {

void PluginTest::SetUpTestSuite() { test::preparePluginEnvironment(); }

writers::WriterHost& PluginTest::load(const Value::Map& parameters) {
  DatasetInfo dataset;
  dataset.global_frame = "map";
  dataset.cameras = {{"camera", "camera/optical_link", 640, 480}};
  parameters_ = Parameters(parameters, "w");
  host_ = std::make_unique<writers::WriterHost>(
      std::vector<writers::WriterChoice>{{"w", type_, folder(), parameters_}}, dataset,
      std::vector<std::string>{test::pluginXml()});
  return *host_;
}

Scene PluginTest::scene(std::int64_t index, std::vector<SceneObject> objects) {
  const CameraModel camera(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0);
  return {index,
          sceneNumber(index),
          "camera",
          Stamp{index},
          camera,
          Pose::Identity(),
          cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(50)),
          std::move(objects),
          [](const std::string& target, const std::string& source) -> Pose {
            throw Error("no transform from " + source + " to " + target);
          }};
}

SceneObject PluginTest::object(const std::string& name) {
  SceneObject object;
  object.name = name;
  object.class_name = name + "_class";
  object.id = name + "_id";
  object.X_GO.translation() = Eigen::Vector3d(0.0, 0.0, 10.0);
  object.X_CO = object.X_GO;
  object.in_view = true;
  object.mask = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  return object;
}

std::map<std::string, std::string> PluginTest::filesOf(const Scene& scene) const {
  std::map<std::string, std::string> files;
  for (const output::OutputFile& file : host_->writeScene(scene).files.files) {
    std::string content = file.text;
    if (file.pixels.data == scene.image.data) content = "<image>";
    for (const SceneObject& object : scene.objects) {
      if (!file.pixels.empty() && file.pixels.data == object.mask.data) {
        content = "<mask " + object.name + ">";
      }
    }
    files[file.path.substr(folder().size())] = content;
  }
  return files;
}

void PluginTest::runAll(const std::vector<Scene>& scenes) const {
  output::StoreOptions options;
  options.folder = folder_.path().string();
  output::DatasetStore store(options, host_->storeWriters());
  for (const Scene& each : scenes) {
    store.commitScene(each.index, each.stamp, host_->writeScene(each).files);
  }
  host_->finalize(store);
}

}  // namespace synthetic_dataset

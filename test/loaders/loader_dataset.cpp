#include "loaders/loader_dataset.h"

#include <algorithm>
#include <utility>

#include "base/yaml_value.h"
#include "run/generator.h"
#include "support/bag_builder.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::test {
namespace {

const std::string kFolder = SYNTHETIC_DATASET_LOADER_TESTS;
constexpr int kMillisecondsApart = 250;

/// The camera's calibration, as camera_calibration writes it.
std::string cameraText(const std::array<double, 5>& distortion) {
  std::string coefficients;
  for (const double each : distortion) {
    coefficients += (coefficients.empty() ? "" : ", ") + fixed(each, 6);
  }
  return R"(image_width: 320
image_height: 240
camera_matrix: {rows: 3, cols: 3, data: [280, 0, 155.5, 0, 280, 121, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [)" +
         coefficients + "]}\n";
}

std::string visualText(const LoaderVisual& visual, std::size_t number, const std::string& colour) {
  return "<visual name='v" + std::to_string(number) + "'><pose>" + visual.pose +
         "</pose><geometry>" + visual.geometry + "</geometry><material><diffuse>" + colour +
         " 1</diffuse><ambient>" + colour + " 1</ambient></material></visual>";
}

std::string modelText(const LoaderObject& object) {
  std::string text = "<model name='" + object.name + "'><link name='body'>";
  for (std::size_t i = 0; i < object.visuals.size(); ++i) {
    text += visualText(object.visuals[i], i, object.colour);
  }
  return text + "</link></model>\n";
}

/// [x, y, z, qx, qy, qz, qw].
Value poseValue(const Pose& pose) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Quaterniond q(pose.rotation());
  return Value(Value::List{p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()});
}

/// Far behind the camera, each in a place of its own.
Pose behindCamera(std::size_t object) {
  return poseAt(3.0 * static_cast<double>(object), 0.0, -50.0);
}

/// The group of an object's parameters.
Value objectValue(const LoaderObject& object, std::size_t index, const TemporaryFolder& inputs) {
  Value::Map group{{"class", object.class_name},
                   {"id", static_cast<std::int64_t>(index)},
                   {"frame", "object_" + std::to_string(index)}};
  Value::List keypoints;
  for (const Eigen::Vector3d& point : object.keypoints_O) {
    keypoints.emplace_back(Value::List{point.x(), point.y(), point.z()});
  }
  if (!keypoints.empty()) group["keypoints"] = keypoints;
  if (!object.model.empty()) {
    group["model"] =
        inputs.write("object_" + std::to_string(index) + ".urdf", object.model).string();
    group["link_frames"] = "{link}";
  }
  return Value(group);
}

/// The parameter `writers` and the groups of the writers in it.
void addWriters(Value::Map& parameters) {
  const bool has_lidars = parameters.count("lidars") != 0;
  const Value file = base::loadYamlFile(kFolder + "/writers.yaml");
  Value::List writers;
  for (const Value& each : *file.as<Value::List>()) {
    Value::Map entry = *each.as<Value::Map>();
    const bool is_truth = entry.at("type") == Value("test/Truth");
    if (!is_truth && has_lidars != (entry.erase("lidar") != 0)) continue;
    const auto settings = entry.find("settings");
    if (settings != entry.end()) {
      Value& group = parameters[*entry.at("name").as<std::string>()];
      // What the dataset itself sets counts before what the file has.
      Value::Map merged = group.as<Value::Map>() ? *group.as<Value::Map>() : Value::Map{};
      merged.insert(settings->second.as<Value::Map>()->begin(),
                    settings->second.as<Value::Map>()->end());
      group = merged;
      entry.erase(settings);
    }
    writers.emplace_back(entry);
  }
  parameters["writers"] = writers;
}

}  // namespace

LoaderVisual boxVisual(const std::string& pose, const std::string& size) {
  return {pose, "<box><size>" + size + "</size></box>"};
}

LoaderVisual sphereVisual(const std::string& pose, double radius) {
  return {pose, "<sphere><radius>" + std::to_string(radius) + "</radius></sphere>"};
}

LoaderDataset::LoaderDataset(const std::vector<LoaderObject>& objects)
    : objects_(objects), cameras_{{"front", Pose::Identity()}} {}

void LoaderDataset::addTime(const std::map<std::string, Pose>& X_GO,
                            const std::map<std::string, Pose>& links) {
  times_.push_back({X_GO, links});
}

void LoaderDataset::addCamera(const std::string& name, const Pose& X_GC) { cameras_[name] = X_GC; }

std::string LoaderDataset::worldText() const {
  std::string text = R"(<sdf version="1.6"><world name="loaders"><gravity>0 0 0</gravity>
<light name="sun" type="directional"><direction>0.3 0.6 0.8</direction>
  <diffuse>0.8 0.8 0.8 1</diffuse></light>)";
  for (const LoaderObject& object : objects_) {
    if (object.model.empty()) text += modelText(object);
  }
  return text + world_ + "</world></sdf>\n";
}

std::string LoaderDataset::writeBag(const TemporaryFolder& inputs) const {
  BagBuilder bag(inputs / "loaders.bag");
  // The end of a recording is no scene: the last time is there twice.
  for (std::size_t i = 0; i <= times_.size(); ++i) {
    const Stamp stamp = milliseconds(1000 + kMillisecondsApart * static_cast<std::int64_t>(i));
    record(times_[std::min(i, times_.size() - 1)], stamp, bag);
  }
  return bag.close();
}

void LoaderDataset::record(const Time& time, Stamp stamp, BagBuilder& bag) const {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const auto found = time.X_GO.find(objects_[i].name);
    bag.move("map", "object_" + std::to_string(i), stamp,
             found != time.X_GO.end() ? found->second : behindCamera(i));
    if (objects_[i].model.empty()) continue;
    for (const auto& [link, X_OL] : time.links) {
      bag.move("object_" + std::to_string(i), link, stamp, X_OL);
    }
  }
}

void LoaderDataset::generate(const std::filesystem::path& folder) const {
  const TemporaryFolder inputs;
  Value::Map parameters = parameters_;
  const Value info_file(inputs.write("camera.yaml", cameraText(distortion_)).string());
  Value::Map cameras;
  for (const auto& [name, X_GC] : cameras_) {
    cameras[name] = Value::Map{{"info_file", info_file}, {"pose", poseValue(X_GC)}};
  }
  if (cameras.size() == 1) {
    parameters["camera"] = cameras.begin()->second;
  } else {
    parameters["cameras"] = cameras;
  }
  Value::List names;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    names.emplace_back(objects_[i].name);
    parameters[objects_[i].name] = objectValue(objects_[i], i, inputs);
  }
  parameters["robot_list"] = names;
  parameters["bag_file"] = writeBag(inputs);
  parameters["simulated_rate"] = 1000.0 / kMillisecondsApart;
  parameters["world"] = inputs.write("loaders.world", worldText()).string();
  parameters["masks"] = Value::Map{{"method", "exact"}};
  parameters["output_folder"] = folder.string();
  parameters["if_exists"] = "overwrite";
  addWriters(parameters);
  run::Reporter reporter;
  run::Generator generator(Value(parameters), reporter,
                           {pluginXml(), kFolder + "/plugin_package/plugins.xml"});
  (void)generator.run();
}

}  // namespace synthetic_dataset::test

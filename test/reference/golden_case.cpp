#include "reference/golden_case.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "base/yaml_value.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::test {
namespace {

const Value& entry(const Value& map, const std::string& name) {
  return map.as<Value::Map>()->at(name);
}

double number(const Value& value) {
  if (const auto* whole = value.as<std::int64_t>()) return static_cast<double>(*whole);
  return *value.as<double>();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

/// A world with one box for each object, within its bounding shape.
std::string boxWorld(const Value::List& objects) {
  std::string world = "<sdf version='1.6'><world name='boxes'>";
  for (const Value& object : objects) {
    world += "<model name='" + *object.as<std::string>() +
             "'><link name='body'><visual name='box'><pose>0 0 0.1 0 0 0</pose><geometry><box>"
             "<size>0.2 0.2 0.2</size></box></geometry></visual></link></model>";
  }
  return world + "</world></sdf>";
}

}  // namespace

GoldenCase::GoldenCase(const std::string& name) : folder_(referenceFolder() / "golden" / name) {
  const Value recorded = base::loadYamlFile((folder_ / "frames.json").string());
  for (const Value& frame : *entry(recorded, "frames").as<Value::List>()) {
    Frame result;
    result.stamp_ns = *entry(frame, "stamp_ns").as<std::int64_t>();
    for (const auto& [object, values] : *entry(frame, "robots").as<Value::Map>()) {
      const Value& aux = entry(values, "aux");
      ObjectFrame& target = result.objects[object];
      const auto& box = *entry(aux, "box_px").as<Value::List>();
      for (std::size_t i = 0; i < 4; ++i) target.box[i] = number(box.at(i));
      target.behind_camera = number(entry(aux, "vertices_behind_camera")) > 0;
    }
    frames_.push_back(std::move(result));
  }
}

Value GoldenCase::parameters(const std::filesystem::path& output,
                             const std::filesystem::path& world_file) const {
  std::string text = readFile(folder_ / "params.yaml");
  text = replaced(text, "$(env NN_CASE_DIR)", folder_.string());
  text = replaced(text, "$(env NN_OUT_DIR)", output.string());
  text = replaced(text, "/robot_list:", "robot_list:");
  Value parameters = base::parseYaml(text, (folder_ / "params.yaml").string());
  auto& map = *parameters.as<Value::Map>();

  Value::List objects;
  if (const auto* list = map["robot_list"].as<Value::List>()) {
    objects = *list;
  } else {
    objects.push_back(map["robot_list"]);
  }
  std::ofstream(world_file) << boxWorld(objects);
  map["world"] = Value(world_file.string());

  const Value poses = base::loadYamlFile((folder_ / "camera_pose.yaml").string());
  const Value& optical = entry(poses, "frames").as<Value::List>()->front();
  map["camera"] = Value(Value::Map{{"info_file", Value((folder_ / "camera_info.yaml").string())},
                                   {"pose", entry(optical, "pose")}});
  return parameters;
}

}  // namespace synthetic_dataset::test

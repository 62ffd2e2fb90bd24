#include "programs/console/ros_parameters.h"

#include <string>

#include <ros/console.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

Value valueFromXmlRpc(XmlRpc::XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return Value(static_cast<bool>(value));
    case XmlRpc::XmlRpcValue::TypeInt:
      return Value(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return Value(static_cast<double>(value));
    case XmlRpc::XmlRpcValue::TypeString:
      return Value(static_cast<std::string>(value));
    case XmlRpc::XmlRpcValue::TypeArray: {
      Value::List list;
      for (int i = 0; i < value.size(); ++i) list.push_back(valueFromXmlRpc(value[i]));
      return list;
    }
    case XmlRpc::XmlRpcValue::TypeStruct: {
      Value::Map map;
      for (auto& [name, entry] : value) map[name] = valueFromXmlRpc(entry);
      return map;
    }
    default:
      return {};
  }
}

namespace {

/// Replaces an object's `model: "param:NAME"` by the text of that ROS parameter. If the parameter
/// is not set, the name stays, which is reported with all other errors.
void takeModelsFromParameters(Value::Map& parameters) {
  const std::string start = "param:";
  for (auto& [group, content] : parameters) {
    auto* settings = content.as<Value::Map>();
    if (settings == nullptr || settings->count("model") == 0) continue;
    Value& model = settings->at("model");
    const auto* text = model.as<std::string>();
    if (text == nullptr || text->rfind(start, 0) != 0) continue;
    const std::string name = text->substr(start.size());
    std::string found;
    if (ros::param::get(name, found) && !found.empty()) model = Value(found);
  }
}

/// The settings of the file that the private parameter `settings_file` names, if it is set. Removes
/// this parameter.
Value::Map takeSettingsFile(Value::Map& parameters, const config::TextFinder& package_folder) {
  const auto entry = parameters.find("settings_file");
  if (entry == parameters.end()) return {};
  const Value file = entry->second;
  parameters.erase(entry);
  if (const auto* name = file.as<std::string>()) {
    return config::loadSettings(*name, package_folder,
                                [](const std::string& text) { ROS_WARN_STREAM(text); });
  }
  throw Error("settings_file: found " + file.kind() + "; it should be the name of a YAML file");
}

}  // namespace

Value readRosParameters(const config::TextFinder& package_folder) {
  XmlRpc::XmlRpcValue found;
  Value parameters = Value::Map{};
  if (ros::param::get(ros::this_node::getName(), found)) parameters = valueFromXmlRpc(found);
  auto* given = parameters.as<Value::Map>();
  if (given == nullptr) {
    throw Error(ros::this_node::getName() + ": found " + parameters.kind() +
                " on the parameter server; it should be the group of this node's parameters");
  }
  Value::Map settings = takeSettingsFile(*given, package_folder);
  config::overrideBy(*given, settings);
  if (settings.count("robot_list") == 0) {
    XmlRpc::XmlRpcValue robots;
    if (ros::param::get("/robot_list", robots)) settings["robot_list"] = valueFromXmlRpc(robots);
  }
  takeModelsFromParameters(settings);
  return settings;
}

}  // namespace synthetic_dataset::programs

#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "plugins/model_shapes.h"
#include "plugins/plugin_harness.h"

namespace synthetic_dataset {

/// A BOP dataset with a rover and a lift.
class Bop : public PluginTest {
 protected:
  Bop() : PluginTest("synthetic_dataset/Bop") {
    addObject("rover", {{-1.0, -0.5, 0.0}, {1.0, 0.5, 0.6}});
    addObject("lift", {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
    dataset_.classes = {{0, "vehicle"}};
    dataset_.setModels([this](std::size_t object) { return models_.at(object); });
  }

  void addObject(const std::string& name, const Cuboid& cuboid_O) {
    ObjectInfo info;
    info.name = name;
    info.class_name = "vehicle";
    info.id = name + "_id";
    dataset_.objects.push_back(info);
    models_.push_back(cuboidModel(cuboid_O));
  }

  [[nodiscard]] nlohmann::json jsonOf(const std::string& file) const {
    std::ifstream stream(folder() + file);
    return nlohmann::json::parse(stream);
  }

  [[nodiscard]] bool exists(const std::string& file) const {
    return std::filesystem::exists(folder() + file);
  }

  /// The rover, and the lift, which hides part of it.
  [[nodiscard]] static std::vector<SceneObject> roverAndLift() {
    SceneObject rover = seen("rover", {100, 80, 50, 40});
    rover.visible_mask = painted(rover.visible_mask(), {100, 80, 20, 40}, false);
    rover.pixels.visible = 30 * 40;
    return {rover, seen("lift", {60, 80, 60, 40})};
  }

  std::vector<ObjectModel> models_;
};

}  // namespace synthetic_dataset

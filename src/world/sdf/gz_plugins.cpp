#include "world/sdf/gz_plugins.h"

#include <charconv>
#include <system_error>

namespace synthetic_dataset::world {

bool isPluginOfGz(const std::string& filename, const std::string& name) {
  // "gz-sim-physics-system", "libgz-sim7-physics-system.so", "ignition-gazebo-physics-system",
  // "libignition-gazebo6-...": Classic's are "libgazebo_ros_camera.so" and the like.
  for (const char* part : {"gz-sim", "ignition-gazebo", "ign-gazebo", "gz_ros2_control"}) {
    if (filename.find(part) != std::string::npos) return true;
  }
  // "gz::sim::systems::Physics", "ignition::gazebo::systems::Physics"
  return name.rfind("gz::sim::", 0) == 0 || name.rfind("ignition::gazebo::", 0) == 0;
}

std::optional<int> readLabel(const Element& element) {
  for (const Element& plugin : element.children("plugin")) {
    const std::string name = plugin.attribute("name");
    const std::string filename = plugin.attribute("filename");
    const bool is_label =
        name == "gz::sim::systems::Label" || name == "ignition::gazebo::systems::Label" ||
        (isPluginOfGz(filename, name) && filename.find("label-system") != std::string::npos);
    const auto text = is_label ? plugin.value("label") : std::nullopt;
    int label = 0;
    if (text &&
        std::from_chars(text->data(), text->data() + text->size(), label).ec == std::errc()) {
      return label;
    }
  }
  return std::nullopt;
}

}  // namespace synthetic_dataset::world

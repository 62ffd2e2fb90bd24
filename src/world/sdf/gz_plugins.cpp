#include "world/sdf/gz_plugins.h"

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

}  // namespace synthetic_dataset::world

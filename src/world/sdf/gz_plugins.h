#pragma once

#include <string>

namespace synthetic_dataset::world {

/// Whether a plugin that a world names is one of gz-sim's own, which Gazebo Classic lacks.
/// @param filename, name  the attributes of SDF's <plugin>
[[nodiscard]] bool isPluginOfGz(const std::string& filename, const std::string& name);

}  // namespace synthetic_dataset::world

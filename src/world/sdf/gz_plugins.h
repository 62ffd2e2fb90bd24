#pragma once

#include <optional>
#include <string>

#include "world/sdf/element.h"

namespace synthetic_dataset::world {

/// Whether a plugin that a world names is one of gz-sim's own, which Gazebo Classic lacks.
/// @param filename, name  the attributes of SDF's <plugin>
[[nodiscard]] bool isPluginOfGz(const std::string& filename, const std::string& name);

/// The label that gz-sim's label plugin gives to the model or visual that contains it.
[[nodiscard]] std::optional<int> readLabel(const Element& element);

}  // namespace synthetic_dataset::world

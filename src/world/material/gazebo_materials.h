#pragma once

#include <optional>
#include <string>

#include "world/description.h"
#include "world/material/texture_loader.h"

namespace synthetic_dataset::world {

/// A material that Gazebo Classic ships under a name such as "Gazebo/Grey". Pictures
/// ("Gazebo/Wood") come from Gazebo's own media if it is installed; otherwise stand-ins are
/// painted.
/// @return nothing for a name that Gazebo does not ship
[[nodiscard]] std::optional<Material> gazeboMaterial(const std::string& name,
                                                     TextureLoader& textures);

/// "; did you mean 'Gazebo/Grey'?" for a name close to one that Gazebo ships, else nothing.
[[nodiscard]] std::string nearGazeboMaterial(const std::string& name);

}  // namespace synthetic_dataset::world

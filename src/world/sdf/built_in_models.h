#pragma once

#include <optional>
#include <string>

namespace synthetic_dataset::world {

/// The models that nearly every world includes and that need no files: the plane "ground_plane" and
/// the light "sun", with the sizes and colours of Gazebo's.
/// @param name  as in a URI; "Ground Plane" and "ground_plane" are the same
/// @return an SDF file's text, or nothing for any other name
[[nodiscard]] std::optional<std::string> builtInModel(const std::string& name);

}  // namespace synthetic_dataset::world

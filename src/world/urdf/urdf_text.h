#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "world/files/findings.h"

namespace synthetic_dataset::world {

/// A model's text and where it comes from.
struct ModelText {
  std::string name;                             ///< for messages: the file's path
  std::optional<std::filesystem::path> folder;  ///< that URIs are relative to; none: of no file
  std::string text;
};

/// URDF as urdfdom may read it.
struct UrdfText {
  std::string text;
  std::map<std::string, std::string> gazebo_materials;  ///< by link: "Gazebo/Grey"
};

/// Resolves what roslaunch and xacro may have left: `$(optenv NAME default)` and `$(env NAME)`
/// from the environment, `$(find package)` and
/// `$(find-pkg-share package)` as `package://package`. An attribute with anything else
/// of the kind is left out, and noted. Blocks of other programs (<gazebo>, <transmission>, ...) go;
/// of Gazebo's the links' materials are kept.
/// A material that is defined nowhere goes too, and is noted.
/// @return nothing where the text is no URDF or has not been through xacro, with the errors
///     reported
[[nodiscard]] std::optional<UrdfText> prepareUrdf(const ModelText& model, Findings& findings);

}  // namespace synthetic_dataset::world

#pragma once

#include <map>
#include <memory>
#include <string>

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include "world/files/findings.h"
#include "world/urdf/urdf_text.h"

namespace synthetic_dataset::world {

/// A robot as urdfdom reads it, which prints nothing meanwhile.
struct UrdfDocument {
  urdf::ModelInterfaceSharedPtr robot;                  ///< a tree of links; null where it is none
  std::map<std::string, std::string> gazebo_materials;  ///< by link
};

/// What is wrong becomes an error: what urdfdom says, and what it does not see (loops, links with
/// two parents).
[[nodiscard]] UrdfDocument readUrdf(const ModelText& model, Findings& findings);

}  // namespace synthetic_dataset::world

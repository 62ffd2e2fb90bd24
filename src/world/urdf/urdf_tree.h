#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "world/sdf/element.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The joint between a link and its parent.
struct UrdfJoint {
  Element element;
  std::string name;
  std::string parent;
  std::string child;
};

/// The kinematic tree of a robot.
struct UrdfTree {
  std::string root;
  std::map<std::string, Element> links;
  std::map<std::string, std::vector<UrdfJoint>> below;  ///< joints by parent link, sorted by name
};

/// @param robot  the file's root element
/// @return nothing if the links do not form a tree, with the reason reported
[[nodiscard]] std::optional<UrdfTree> readUrdfTree(const Element& robot,
                                                   const SourceLocation& location,
                                                   SdfReading& reading);

}  // namespace synthetic_dataset::world

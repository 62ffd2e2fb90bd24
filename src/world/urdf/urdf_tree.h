#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "world/sdf/element.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// What holds a link to its parent.
struct UrdfJoint {
  Element element;
  std::string name;
  std::string parent;
  std::string child;
};

/// The links of a robot as they hang on one another.
struct UrdfTree {
  std::string root;
  std::map<std::string, Element> links;
  std::map<std::string, std::vector<UrdfJoint>> below;  ///< by parent; in the order of their names
};

/// @param robot  the file's root element
/// @return nothing where the links are no tree, with what is wrong reported
[[nodiscard]] std::optional<UrdfTree> readUrdfTree(const Element& robot,
                                                   const SourceLocation& location,
                                                   SdfReading& reading);

}  // namespace synthetic_dataset::world

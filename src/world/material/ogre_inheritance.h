#pragma once

#include <functional>
#include <string>

#include "world/material/ogre_script.h"

namespace synthetic_dataset::world {

/// Returns the section of a kind and name, or null.
using OgreLookUp =
    std::function<const OgreObject*(const std::string& kind, const std::string& name)>;

/// A section with everything that it and its inner sections inherit (OGRE 1.x manual, "Script
/// Inheritance"): inner sections of the same kind match by name, unnamed ones by their position,
/// and the properties of a child are added to those of its parent.
/// @throws Error "line 7: material 'A' inherits from 'B', which is not there", or if it inherits
///     from itself or becomes far too large through inheritance
[[nodiscard]] OgreObject withInherited(const OgreObject& object, const OgreLookUp& lookUp);

}  // namespace synthetic_dataset::world

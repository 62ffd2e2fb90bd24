#pragma once

#include <functional>
#include <string>

#include "world/material/ogre_script.h"

namespace synthetic_dataset::world {

/// Gives a section by kind and name, or null.
using OgreLookUp =
    std::function<const OgreObject*(const std::string& kind, const std::string& name)>;

/// A section with all that it inherits, its inner sections' too (OGRE 1.x manual, "Script
/// Inheritance"): of those with the same kind, sections match by name, unnamed ones by their
/// place, and what a child says is added to what its parent says.
/// @throws Error "line 7: material 'A' inherits from 'B', which is not there", or inherits from
///     itself, or grows beyond all measure by what it inherits
[[nodiscard]] OgreObject withInherited(const OgreObject& object, const OgreLookUp& lookUp);

}  // namespace synthetic_dataset::world

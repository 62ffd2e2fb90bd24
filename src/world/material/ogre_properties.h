#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "world/material/ogre_script.h"

namespace synthetic_dataset::world {

/// The last property of this name, which is the one that counts, or null.
[[nodiscard]] const OgreProperty* propertyOf(const OgreObject& object, const std::string& name);

/// The value of a property at an index; empty if there is none.
[[nodiscard]] std::string wordOf(const OgreObject& object, const std::string& name,
                                 std::size_t index = 0);

/// The inner sections of a kind.
[[nodiscard]] std::vector<const OgreObject*> sectionsOf(const OgreObject& object,
                                                        const std::string& kind);

/// The numbers among a property's values, from index `first` to the end.
/// @param least  how many there have to be at least
/// @throws Error "line 7: diffuse: found 'red'; it should be 3 numbers or more"
[[nodiscard]] std::vector<float> numbersOf(const OgreProperty& property, std::size_t first,
                                           std::size_t least);

}  // namespace synthetic_dataset::world

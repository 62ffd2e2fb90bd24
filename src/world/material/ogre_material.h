#pragma once

#include <string>
#include <vector>

#include "world/material/material_source.h"
#include "world/material/ogre_script.h"

namespace synthetic_dataset::world {

struct OgreMaterial {
  MaterialSource source;           ///< its picture references have only a URI
  std::vector<std::string> notes;  ///< what is drawn differently from OGRE
};

/// Reads the material that an OGRE 1.x script describes, from the first technique without a scheme.
/// Of several passes, the last one that covers what is behind it is used; properties that it does
/// not set come from the other passes. Later passes that are alpha-blended over it, and have a
/// picture, become its overlays. The first picture that is neither a reflection nor named for
/// another use is the diffuse one; a later one that modulates it becomes its factor. Shader
/// programs are not run: the names of their samplers tell what the pictures are for, and without a
/// picture, a colour that is passed to them becomes the diffuse colour.
/// @param material  with everything that it inherits, and its variables replaced
/// @throws Error "line 7: diffuse: found 'x'; ..."
[[nodiscard]] OgreMaterial readOgreMaterial(const OgreObject& material);

}  // namespace synthetic_dataset::world

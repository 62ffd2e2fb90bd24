#pragma once

#include <string>
#include <vector>

#include "world/material/material_source.h"
#include "world/material/ogre_script.h"

namespace synthetic_dataset::world {

struct OgreMaterial {
  MaterialSource source;           ///< its pictures' references have a URI only
  std::vector<std::string> notes;  ///< what is drawn otherwise than OGRE draws it
};

/// The material that an OGRE 1.x script describes: that of the first technique without a scheme.
/// The last of several passes that covers what is behind it counts; what it leaves open the others
/// say. Passes after it that are blended with it by alpha, and have a picture, are its overlays.
/// The first of several pictures that is neither a reflection nor named for another use is the
/// diffuse one; another after it that modulates it is its factor. Shader programs are not run: the
/// names of their samplers say what pictures are for, and without a picture a colour that is given
/// to them is the diffuse one.
/// @param material  with all that it inherits, its variables replaced
/// @throws Error "line 7: diffuse: found 'x'; ..."
[[nodiscard]] OgreMaterial readOgreMaterial(const OgreObject& material);

}  // namespace synthetic_dataset::world

#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// Makes every normal unit length; one that is missing (zero) or no number becomes the mean of its
/// vertex' triangles, weighted by area.
/// @param mesh  with one normal a position
void completeNormals(Mesh& mesh);

}  // namespace synthetic_dataset::world

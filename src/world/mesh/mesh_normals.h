#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// Normalizes every normal; one that is missing (zero) or not a number becomes the mean normal of
/// its vertex's triangles, weighted by area.
/// @param mesh  with one normal per position
void completeNormals(Mesh& mesh);

}  // namespace synthetic_dataset::world

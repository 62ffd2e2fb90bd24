#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// Whether a mesh is the surface of bodies, so that a ray from outside never meets the back of a
/// triangle before the front of another: every edge is shared by triangles that wind alike, and
/// what they enclose has a volume above 0, piece by piece. Vertices at the same place are the same;
/// those that nearly are, as of seams that were worked out twice, may be.
[[nodiscard]] bool isSurfaceOfBodies(const Mesh& mesh);

}  // namespace synthetic_dataset::world

#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// Whether a mesh is the surface of bodies, so that from outside no ray meets the back of a
/// triangle before the front of another: every edge is that of two triangles that wind alike, and
/// what they enclose has a volume above 0, piece by piece. (Where a piece passes through itself, a
/// part of it may be turned inside out all the same.) Vertices are the same where single precision,
/// at the mesh's size, does not distinguish them.
[[nodiscard]] bool isSurfaceOfBodies(const Mesh& mesh);

}  // namespace synthetic_dataset::world

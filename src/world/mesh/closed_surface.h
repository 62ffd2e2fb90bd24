#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// Whether a mesh is the closed surface of solid bodies, so that no ray from outside meets the back
/// of a triangle before the front of another: every edge is shared by exactly two triangles that
/// wind consistently, and each connected piece encloses a volume above 0. (If a piece intersects
/// itself, a part of it may still be inside out.) Vertices count as the same if single precision,
/// at the mesh's size, does not distinguish them.
[[nodiscard]] bool isSurfaceOfBodies(const Mesh& mesh);

}  // namespace synthetic_dataset::world

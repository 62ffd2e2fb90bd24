#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "render/shadows/map_depths.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Draws what a body casts: for the many small triangles of bodies that move, several times as fast
/// as OpenGL without a graphics card.
///
/// Corners are rounded to 1/256 of a texel, and what is on a triangle's side belongs to it, so that
/// there are no gaps between triangles.
/// @param map_from_mesh  to column, row [texel] and depth, times a factor above 0:
///     1 in parallel light, else the distance along the light's axis
/// @param size  of the map's side [texel]
/// @param fronts_alone  leaves out triangles that turn away from the light
/// @return the texels around it, with depth 1 where it is not; nothing where all of it lies beside
///         the map. What lies before depth 0 counts as there
[[nodiscard]] std::optional<MapPiece> castPiece(const world::Mesh& mesh,
                                                const Eigen::Projective3f& map_from_mesh, int size,
                                                bool fronts_alone);

}  // namespace synthetic_dataset::render

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::world {

/// A closed polygon; the last point is joined to the first.
using Outline = std::vector<Eigen::Vector2d>;

/// Triangles that fill the area enclosed by outlines.
struct Triangulation {
  std::vector<Outline> outlines;  ///< the given ones, each with the filled area on its left,
                                  ///< without points that repeat their neighbour
  std::vector<std::array<std::size_t, 3>>
      triangles;  ///< counter-clockwise; indices of points, counted through all outlines
};

/// Fills outlines of either winding: an outline inside another is a hole, one inside that is filled
/// again, and so on (the even-odd rule). Holes are joined to the outline around them, then ears are
/// clipped (D. Eberly, "Triangulation by Ear Clipping", 2002).
/// @throws Error for an outline with fewer than three distinct points or without an area, for
///     crossing lines, and for more than a few thousand points
[[nodiscard]] Triangulation triangulate(const std::vector<Outline>& outlines);

}  // namespace synthetic_dataset::world

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::world {

/// A closed line of points; the last is joined to the first.
using Outline = std::vector<Eigen::Vector2d>;

/// Triangles that fill what outlines enclose.
struct Triangulation {
  std::vector<Outline> outlines;  ///< the given ones, each with the filled area on its left,
                                  ///< without points that repeat their neighbour
  std::vector<std::array<std::size_t, 3>>
      triangles;  ///< counter-clockwise; numbers of points, counted through all outlines
};

/// Fills outlines of any direction: within another one is a hole, within that filled again, and so
/// on (the even-odd rule). Holes are joined to what encloses them, and ears cut off (D. Eberly,
/// "Triangulation by Ear Clipping", 2002).
/// @throws Error for an outline of less than three different points or without an area, for lines
///     that cross, and for more than some thousand points
[[nodiscard]] Triangulation triangulate(const std::vector<Outline>& outlines);

}  // namespace synthetic_dataset::world

#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset {

/// The turned box around a mask's pixels: the rectangle of least area that holds them (one of its
/// sides lies along an edge of their convex hull: Freeman and Shapira, "Determining the
/// minimum-area encasing rectangle for an arbitrary closed curve", CACM 18(7), 1975).
///
/// No corner lies outside the image: of the rectangles along the hull's edges and along the image's
/// that do not reach past its edge, the least is taken. Only of what reaches the image's edge, and
/// where that is a poor fit, as of a thin bar that leaves the image askew, a rectangle that does
/// reach past is cut back along one of its sides, and no longer holds the pixels at the image's
/// edge: where that overlaps with the hull (intersection over union) by a quarter more.
/// @return the corners [px], clockwise on the screen, where the image spans (0, 0) to (width,
///     height); nothing for an empty mask
[[nodiscard]] std::optional<std::array<Eigen::Vector2d, 4>> orientedBox(const Mask& mask);

}  // namespace synthetic_dataset

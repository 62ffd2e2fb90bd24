#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset {

/// The oriented box around a mask's pixels: the rectangle of least area that contains them (one of
/// its sides lies along an edge of their convex hull: Freeman and Shapira, "Determining the
/// minimum-area encasing rectangle for an arbitrary closed curve", CACM 18(7), 1975).
///
/// No corner lies outside the image: the smallest rectangle is taken, along an edge of the hull or
/// of the image, that does not reach past the image. If the mask touches the image's edge, a
/// rectangle that does reach past it is instead cut back along one of its sides, so that it misses
/// pixels at the image's edge, provided that this improves the overlap with the hull (intersection
/// over union) by a quarter, as for a thin bar that leaves the image at an angle.
/// @return the corners [px], clockwise on the screen, where the image spans (0, 0) to (width,
///     height); nothing for an empty mask
[[nodiscard]] std::optional<std::array<Eigen::Vector2d, 4>> orientedBox(const Mask& mask);

}  // namespace synthetic_dataset

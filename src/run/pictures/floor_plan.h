#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "run/pictures/map_paper.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// Draws a world as seen from above: the ground in light grey and, in darker grey, what stands on
/// it up to the height of a ceiling.
/// @param links  only those of static models and props are drawn
/// @param X_WL  of each link
/// @param ground  its height [m]
void drawFloorPlan(MapPaper& paper, const std::vector<world::LinkInstance>& links,
                   const std::vector<Pose>& X_WL, double ground);

/// The height [m] of the lowest large floor: horizontal, and with at least half the horizontal area
/// found at any other height. 0 if nothing is horizontal.
[[nodiscard]] double floorHeight(const std::vector<world::LinkInstance>& links,
                                 const std::vector<Pose>& X_WL);

/// Bounds, seen from above, of everything that stands on the ground or, failing that, of the ground
/// itself; empty if there is neither.
[[nodiscard]] Eigen::AlignedBox2d floorExtent(const std::vector<world::LinkInstance>& links,
                                              const std::vector<Pose>& X_WL, double ground);

}  // namespace synthetic_dataset::run

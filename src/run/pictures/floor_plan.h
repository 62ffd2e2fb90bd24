#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "run/pictures/map_paper.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// Draws what stands in a world as seen from above: the ground in light grey, and in darker grey
/// what stands on it up to the height of a ceiling.
/// @param links  of which static models and props are drawn
/// @param X_WL  of each link
/// @param ground  its height [m]
void drawFloorPlan(MapPaper& paper, const std::vector<world::LinkInstance>& links,
                   const std::vector<Pose>& X_WL, double ground);

/// The height [m] of the lowest large floor: level, and of half the area at least that there is at
/// any height. 0 where nothing is level.
[[nodiscard]] double floorHeight(const std::vector<world::LinkInstance>& links,
                                 const std::vector<Pose>& X_WL);

/// Round all that stands on the ground, as seen from above, or the ground itself; empty where
/// nothing is.
[[nodiscard]] Eigen::AlignedBox2d floorExtent(const std::vector<world::LinkInstance>& links,
                                              const std::vector<Pose>& X_WL, double ground);

}  // namespace synthetic_dataset::run

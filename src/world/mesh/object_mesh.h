#pragma once

#include <vector>

#include "synthetic_dataset/object_model.h"
#include "synthetic_dataset/pose.h"
#include "world/description.h"

namespace synthetic_dataset::world {

/// All of an object's visuals as one mesh in the object's frame, without the vertices that no
/// triangle uses. The colour of a vertex is the one it is drawn in under white light: its own,
/// multiplied by the material's and by that of the diffuse picture at that point.
/// @param X_OL  of each link
[[nodiscard]] ObjectModel objectModel(const std::vector<const Link*>& links,
                                      const std::vector<Pose>& X_OL);

}  // namespace synthetic_dataset::world

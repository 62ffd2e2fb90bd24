#pragma once

#include <string>
#include <vector>

#include "config/config.h"
#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset {

/// What the user should know of a bounding shape or keypoints that have little to do with the
/// object's model, as numbers in millimetres have.
/// @param box_O  round the model, in the object's frame
[[nodiscard]] std::vector<std::string> sizeNotes(const config::ObjectConfig& object,
                                                 const Cuboid& box_O);

}  // namespace synthetic_dataset

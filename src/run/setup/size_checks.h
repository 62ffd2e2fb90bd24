#pragma once

#include "base/diagnostics.h"
#include "scene/object_options.h"
#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset::run {

/// Warns of a bounding shape or keypoints that have little to do with the object's model, as
/// numbers in millimetres have.
/// @param box_O  around the model, in the object's frame
void checkSizes(const scene::ObjectOptions& object, const Cuboid& box_O,
                base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::run

#pragma once

#include <vector>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::render {

/// X_WL of all links, for each shadow: where they cast it.
using CasterPoses = std::vector<std::vector<Pose>>;

}  // namespace synthetic_dataset::render

#pragma once

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::randomize {

/// How much of a mesh's surface one unit of its texture coordinates covers along u and v, averaged
/// over its area [m]; 0 if it has none. A plane of 1 km that shows its texture once has 1000.
[[nodiscard]] Eigen::Vector2d metresPerTexture(const world::Mesh& mesh);

}  // namespace synthetic_dataset::randomize

#pragma once

#include <optional>

#include "randomize/placement/placement_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads a camera's group `sample`, or nothing where there is none.
/// @param camera  its group
[[nodiscard]] std::optional<randomize::CameraSampling> readCameraSampling(Parameters camera);

}  // namespace synthetic_dataset::config

#pragma once

#include "render/sensor/sensor_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads a camera's `depth_noise`; exact where it is not there.
/// @param camera  the group above it
[[nodiscard]] render::DepthNoise readDepthNoise(Parameters& camera);

}  // namespace synthetic_dataset::config

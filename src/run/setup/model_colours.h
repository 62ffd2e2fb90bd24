#pragma once

#include <vector>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::run {

/// The bright colours that stand out most of a model, at most two of different hues: red, green,
/// blue, sRGB-encoded, 0 .. 1. None of a grey one.
[[nodiscard]] std::vector<Eigen::Vector3d> strikingColours(const world::Model& model);

}  // namespace synthetic_dataset::run

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "randomize/placement/placement_options.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// The models of a run's distractors, "distractor_1" and on: boxes, balls and cylinders of random
/// sizes and patterns, or the given models in turn. Each depends only on the seed and its number.
/// @param load  reads a model, given its URI and its new name
/// @throws Error as PictureFolder does for a folder of textures; and whatever `load` throws
[[nodiscard]] std::vector<world::Model> makeDistractors(
    const randomize::DistractorOptions& config, std::uint64_t seed,
    const std::function<world::Model(const std::string& uri, const std::string& name)>& load);

}  // namespace synthetic_dataset::randomize

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "randomize/placement/placement_options.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// The models of a run's distractors, "distractor_1" and on: boxes, balls and cylinders of random
/// sizes and patterns, or the given models in turn. They follow from the seed and each one's number
/// alone.
/// @param load  reads a model, by its URI and its new name
/// @throws Error as PictureFolder does for a folder of textures; and what `load` throws
[[nodiscard]] std::vector<world::Model> makeDistractors(
    const randomize::DistractorOptions& config, std::uint64_t seed,
    const std::function<world::Model(const std::string& uri, const std::string& name)>& load);

}  // namespace synthetic_dataset::randomize

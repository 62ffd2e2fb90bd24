#pragma once

#include <string>
#include <vector>

#include "run/setup/input_cache.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Settings in which `randomize: {preset: transfer}` is fully expanded.
struct ExpandedPreset {
  Value settings;
  std::vector<std::string> notes;  ///< which parts were not applied, and why
};

/// Expands the preset: the settings from which networks that are to work on photographs learn best,
/// as measured by benchmark/transfer. Explicit settings override it. If objects are placed rather
/// than recorded, and the settings have no world, placement or motions of their own, the objects
/// are given surroundings whose lengths are scaled to the largest object's size; otherwise poses
/// and cameras are kept, and only looks vary from scene to scene. Settings without a preset are
/// returned unchanged.
[[nodiscard]] ExpandedPreset expandPreset(const Value& settings, InputCache& inputs);

}  // namespace synthetic_dataset::run

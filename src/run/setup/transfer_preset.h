#pragma once

#include <string>
#include <vector>

#include "run/setup/input_cache.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Settings with what `randomize: {preset: transfer}` stands for, all of it spelt out.
struct ExpandedPreset {
  Value settings;
  std::vector<std::string> notes;  ///< what of it was not applied, and why
};

/// Spells the preset out: what networks learn from best that are to work on photographs, as
/// benchmark/transfer measures it. Whatever the settings say themselves overrides it. Objects that
/// are placed without a world, a placement or motions of the settings' own get surroundings, whose
/// lengths follow from the largest object's size; all others keep their poses and cameras, and look
/// different in each scene. Settings without a preset are answered as they are.
[[nodiscard]] ExpandedPreset expandPreset(const Value& settings, InputCache& inputs);

}  // namespace synthetic_dataset::run

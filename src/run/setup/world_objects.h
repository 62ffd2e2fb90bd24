#pragma once

#include "base/diagnostics.h"
#include "run/setup/input_cache.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Settings in which each model selected by `world_objects` is an object of `robot_list` with a
/// group of its own, and messages about this.
struct SpelledWorldObjects {
  Value settings;
  base::Diagnostics diagnostics;
};

/// Settings whose `world_objects` are wrong, or whose worlds cannot be read, are returned
/// unchanged: whatever reads them next reports the error.
/// @param inputs  its worlds have the models
[[nodiscard]] SpelledWorldObjects spellOutWorldObjects(const Value& settings, InputCache& inputs);

}  // namespace synthetic_dataset::run

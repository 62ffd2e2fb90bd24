#pragma once

#include "base/diagnostics.h"
#include "run/setup/input_cache.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Settings in which each model that `world_objects` means is an object of `robot_list` with a
/// group of its own, and what is to be said of it.
struct SpelledWorldObjects {
  Value settings;
  base::Diagnostics diagnostics;
};

/// Settings whose `world_objects` are wrong, or whose worlds cannot be read, stay as they are: what
/// reads them next says so.
/// @param inputs  whose worlds have the models
[[nodiscard]] SpelledWorldObjects spellOutWorldObjects(const Value& settings, InputCache& inputs);

}  // namespace synthetic_dataset::run

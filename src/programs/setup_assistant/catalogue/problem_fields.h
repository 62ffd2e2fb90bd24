#pragma once

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Gives each problem of a set-up the setting that the page shows it at, as its `path`: the one
/// that it is about, an object or a camera that it names, else the first setting that its cure or
/// its text names. Problems that name none keep none.
/// @param setup  with `problems`, and `about`, `found` and `cure` in each
/// @param settings  all that hold
void addFields(Value::Map& setup, const Value& settings);

}  // namespace synthetic_dataset::programs

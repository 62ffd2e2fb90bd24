#pragma once

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// Replaces each object of `robot_list` with a `count` of 2 or more by that many objects: `cone`
/// with `count: 3` becomes `cone_1` to `cone_3`, with the settings of `cone`; an id that is a whole
/// number is counted up from there, any other id gets the number appended. Settings stay as they
/// are if objects follow a recording, in which each has a frame of its own.
[[nodiscard]] Value::Map withCounts(Value::Map settings);

}  // namespace synthetic_dataset::config

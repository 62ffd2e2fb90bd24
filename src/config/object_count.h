#pragma once

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// Settings in which each object of `robot_list` with a `count` of 2 or more is as many objects:
/// `cone` with `count: 3` becomes `cone_1` to `cone_3`, with what the settings say of `cone`; an id
/// that is a whole number is counted up from there, another gets the number behind it. Left as it
/// is where objects follow a recording, in which each has a frame of its own.
[[nodiscard]] Value::Map withCounts(Value::Map settings);

}  // namespace synthetic_dataset::config

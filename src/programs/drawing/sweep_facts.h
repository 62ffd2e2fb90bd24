#pragma once

#include "plugins/readback/labelled_cloud.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// A sweep's figures: `lidar`, `points`, `rays` if their number is known, `labelled`, and how many
/// points each of `classes` (by name; "" for points without a class) and each of `objects` has.
[[nodiscard]] Value::Map sweepFacts(const formats::LabelledCloud& cloud);

}  // namespace synthetic_dataset::programs

#pragma once

#include "plugins/readback/labelled_cloud.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// A sweep's numbers: `lidar`, `points`, `rays` where it is known how many there were, `labelled`,
/// and how many points each of `classes` (by name; "" for those of none) and each of `objects` has.
[[nodiscard]] Value::Map sweepFacts(const formats::LabelledCloud& cloud);

}  // namespace synthetic_dataset::programs

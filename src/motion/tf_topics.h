#pragma once

#include <string>

#include "motion/bag_reader.h"
#include "motion/topic_reader.h"

namespace synthetic_dataset::motion {

/// Readers of the topics `/tf` and `/tf_static` (or `tf` and `tf_static`) of the bags.
/// @throws ErrorList: messages of another type; or, if none of the bags has any, no messages or no
///     transforms
[[nodiscard]] TopicReaders tfReaders(const BagReader& bags);

}  // namespace synthetic_dataset::motion

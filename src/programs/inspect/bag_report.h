#pragma once

#include <string>

#include "motion/bag_contents.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// What a recording has, for the eye: frames as a tree with rate, times and how far each travels;
/// topics; which frames look like robots and cameras.
[[nodiscard]] std::string bagText(const motion::BagContents& contents);

/// The same for programs. Times and lengths are numbers [s], [m].
[[nodiscard]] Value bagValue(const motion::BagContents& contents);

}  // namespace synthetic_dataset::programs

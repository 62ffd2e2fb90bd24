#pragma once

#include <cstddef>
#include <vector>

#include "base/random/random_source.h"

namespace synthetic_dataset::base {

/// 0 <= number < count, each as likely as its weight says.
/// @param count  > 0
/// @param weights  as many as count, none below 0 and one above it; empty: all alike
[[nodiscard]] std::size_t weightedIndex(RandomSource& source, std::size_t count,
                                        const std::vector<double>& weights);

}  // namespace synthetic_dataset::base

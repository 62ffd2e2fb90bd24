#pragma once

#include <cstdint>

#include "base/random/random_source.h"

namespace synthetic_dataset::randomize::natural {

/// 0 <= number < count. A picture takes thousands of draws, and base::RandomSource::index() needs
/// two divisions for each; the bias of this method, below 2^-32, cannot be seen.
[[nodiscard]] inline int below(base::RandomSource& random, int count) {
  return static_cast<int>(((random.bits() >> 32U) * static_cast<std::uint64_t>(count)) >> 32U);
}

/// low <= number <= high.
[[nodiscard]] inline int between(base::RandomSource& random, int low, int high) {
  return low + below(random, high - low + 1);
}

[[nodiscard]] inline bool chance(base::RandomSource& random, double probability) {
  return random.unit() < probability;
}

}  // namespace synthetic_dataset::randomize::natural

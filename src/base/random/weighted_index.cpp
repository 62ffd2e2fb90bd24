#include "base/random/weighted_index.h"

#include <numeric>

namespace synthetic_dataset::base {

std::size_t weightedIndex(RandomSource& source, std::size_t count,
                          const std::vector<double>& weights) {
  if (weights.empty()) return source.index(count);
  double rest = source.unit() * std::accumulate(weights.begin(), weights.end(), 0.0);
  std::size_t last = 0;  // with a weight above 0; rounding may leave a rest after it
  for (std::size_t i = 0; i < count; ++i) {
    if (weights[i] <= 0.0) continue;
    last = i;
    rest -= weights[i];
    if (rest < 0.0) break;
  }
  return last;
}

}  // namespace synthetic_dataset::base

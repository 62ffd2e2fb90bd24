#include "base/random/random_normal.h"

#include <cmath>

#include "base/random/random_seed.h"

namespace synthetic_dataset::base {
namespace {

/// Above 0, up to 1.
double unit(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 1.0) * 0x1.0p-53; }

}  // namespace

NormalPair randomNormals(std::uint64_t seed, std::uint64_t place) {
  constexpr double kTwoPi = 6.283185307179586;
  const std::uint64_t counter = mixedBits(seed) + 2 * place * kCounterStep;
  // Box and Muller 1958.
  const double radius = std::sqrt(-2.0 * std::log(unit(mixedBits(counter + kCounterStep))));
  const double angle = kTwoPi * unit(mixedBits(counter + 2 * kCounterStep));
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace synthetic_dataset::base

#include "base/random/random_seed.h"

#include <cmath>

#include "synthetic_dataset/fingerprint.h"

namespace synthetic_dataset::base {
namespace {

std::uint64_t mixed(std::uint64_t x) { return mixedBits(x + kCounterStep); }

/// 0 < number <= 1.
double unit(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 1.0) * 0x1.0p-53; }

}  // namespace

std::uint64_t randomSeed(std::uint64_t run_seed, std::int64_t scene_index,
                         std::string_view purpose) {
  const std::uint64_t of_scene = mixed(mixed(run_seed) ^ static_cast<std::uint64_t>(scene_index));
  return mixed(of_scene ^ Fingerprint(purpose).value());
}

NormalPair randomNormals(std::uint64_t seed, std::uint64_t place) {
  constexpr double kTwoPi = 6.283185307179586;
  const std::uint64_t counter = mixedBits(seed) + 2 * place * kCounterStep;
  // Box and Muller 1958.
  const double radius = std::sqrt(-2.0 * std::log(unit(mixedBits(counter + kCounterStep))));
  const double angle = kTwoPi * unit(mixedBits(counter + 2 * kCounterStep));
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace synthetic_dataset::base

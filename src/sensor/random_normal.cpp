#include "sensor/random_normal.h"

#include <cmath>

namespace synthetic_dataset::sensor {
namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): a counter made random.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// Above 0, up to 1.
double unit(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 1.0) * 0x1.0p-53; }

}  // namespace

NormalPair randomNormals(std::uint64_t seed, std::uint64_t place) {
  constexpr std::uint64_t kStep = 0x9E3779B97F4A7C15ULL;
  constexpr double kTwoPi = 6.283185307179586;
  const std::uint64_t counter = mixed(seed) + 2 * place * kStep;
  // Box and Muller 1958.
  const double radius = std::sqrt(-2.0 * std::log(unit(mixed(counter + kStep))));
  const double angle = kTwoPi * unit(mixed(counter + 2 * kStep));
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace synthetic_dataset::sensor

#include "base/random/random_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/random/random_seed.h"

namespace synthetic_dataset::base {

RandomSource::RandomSource(std::uint64_t run_seed, std::int64_t scene_index,
                           std::string_view purpose)
    : RandomSource(randomSeed(run_seed, scene_index, purpose)) {}

std::uint64_t RandomSource::bits() {
  state_ += kCounterStep;
  return mixedBits(state_);
}

double RandomSource::unit() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

double RandomSource::normal() { return randomNormals(bits(), 0).first; }

std::size_t RandomSource::index(std::size_t count) {
  // The incomplete last block of 64-bit numbers is rejected: it would make small results likelier.
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t limit = most - most % count;
  std::uint64_t draw = bits();
  while (draw >= limit) draw = bits();
  return static_cast<std::size_t>(draw % count);
}

std::vector<std::size_t> RandomSource::choice(std::size_t count, std::size_t all) {
  std::vector<std::size_t> numbers(all);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  // The first steps of a Fisher-Yates shuffle.
  for (std::size_t i = 0; i < count; ++i) std::swap(numbers[i], numbers[i + index(all - i)]);
  numbers.resize(count);
  return numbers;
}

double RandomSource::angle() { return M_PI - 2.0 * M_PI * unit(); }

Eigen::Vector3d RandomSource::direction() {
  // Archimedes: the heights of points on a sphere are uniform.
  const double z = uniform(-1.0, 1.0);
  const double azimuth = angle();
  const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

Eigen::Quaternion<double, Eigen::DontAlign> RandomSource::orientation() {
  const double share = unit();
  const double first = angle();
  const double second = angle();
  const double a = std::sqrt(1.0 - share);
  const double b = std::sqrt(share);
  return {b * std::cos(second), a * std::sin(first), a * std::cos(first), b * std::sin(second)};
}

}  // namespace synthetic_dataset::base

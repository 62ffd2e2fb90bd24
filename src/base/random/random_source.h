#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

namespace synthetic_dataset::base {

/// A sequence of random numbers that is the same on every machine: the standard library's
/// distributions differ from implementation to implementation. SplitMix64 (Steele, Lea and Flood
/// 2014).
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : state_(seed) {}

  /// Seeded by randomSeed().
  RandomSource(std::uint64_t run_seed, std::int64_t scene_index, std::string_view purpose);

  [[nodiscard]] std::uint64_t bits();

  /// 0 <= number < 1.
  [[nodiscard]] double unit();

  /// A number between the two; either may be the greater.
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * unit(); }

  /// Normally distributed with mean 0 and standard deviation 1.
  [[nodiscard]] double normal();

  /// 0 <= number < count, all equally likely. @param count  > 0
  [[nodiscard]] std::size_t index(std::size_t count);

  /// Draws `count` of the numbers 0 .. all - 1 without replacement, in random order.
  /// @param count  <= all
  [[nodiscard]] std::vector<std::size_t> choice(std::size_t count, std::size_t all);

  /// A heading: -pi < angle <= pi.
  [[nodiscard]] double angle();

  /// A unit vector, uniformly distributed over the sphere.
  [[nodiscard]] Eigen::Vector3d direction();

  /// An orientation, uniformly distributed (Shoemake 1992).
  [[nodiscard]] Eigen::Quaternion<double, Eigen::DontAlign> orientation();

 private:
  std::uint64_t state_;
};

}  // namespace synthetic_dataset::base

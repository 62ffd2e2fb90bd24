#pragma once

#include <cstdint>
#include <string_view>

namespace synthetic_dataset::base {

/// The step of SplitMix64's counter (Steele, Lea and Flood 2014).
inline constexpr std::uint64_t kCounterStep = 0x9E3779B97F4A7C15ULL;

/// SplitMix64's finaliser: every input bit changes half of the output bits.
[[nodiscard]] constexpr std::uint64_t mixedBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// The seed of something random: a function of only the run's seed, the scene and the purpose, so
/// that any scene can be made by itself and the draws for one purpose do not affect those for
/// others.
[[nodiscard]] std::uint64_t randomSeed(std::uint64_t run_seed, std::int64_t scene_index,
                                       std::string_view purpose);

/// Two independent normal numbers (mean 0, standard deviation 1) that are a function of a seed and
/// a place: the same on every machine and in whatever order they are asked for.
struct NormalPair {
  double first;
  double second;
};
[[nodiscard]] NormalPair randomNormals(std::uint64_t seed, std::uint64_t place);

}  // namespace synthetic_dataset::base

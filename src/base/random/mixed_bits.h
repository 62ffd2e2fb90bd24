#pragma once

#include <cstdint>

namespace synthetic_dataset::base {

/// The step of SplitMix64's counter (Steele, Lea and Flood 2014).
inline constexpr std::uint64_t kCounterStep = 0x9E3779B97F4A7C15ULL;

/// SplitMix64's finaliser: every bit in changes half of those out.
[[nodiscard]] constexpr std::uint64_t mixedBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

}  // namespace synthetic_dataset::base

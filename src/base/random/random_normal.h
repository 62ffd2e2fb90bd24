#pragma once

#include <cstdint>

namespace synthetic_dataset::base {

/// Two independent normal numbers (mean 0, standard deviation 1) that belong to a seed and a place:
/// the same on every machine and in whatever order they are asked for.
struct NormalPair {
  double first;
  double second;
};
[[nodiscard]] NormalPair randomNormals(std::uint64_t seed, std::uint64_t place);

}  // namespace synthetic_dataset::base

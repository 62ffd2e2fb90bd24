#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "base/random/random_seed.h"

namespace synthetic_dataset::render {

/// The seed for the contents of one cell of a grid, which do not depend on which other cells are
/// visited.
template <class Cell>
[[nodiscard]] std::uint64_t cellSeed(std::uint64_t seed, const Eigen::MatrixBase<Cell>& cell) {
  for (Eigen::Index axis = 0; axis < cell.size(); ++axis) {
    seed = base::mixedBits(seed + static_cast<std::uint64_t>(cell[axis]) * base::kCounterStep);
  }
  return seed;
}

}  // namespace synthetic_dataset::render

#pragma once

#include <cstddef>

namespace synthetic_dataset::randomize {

/// The row-major index of an entry in a table.
[[nodiscard]] inline std::size_t flatIndex(int row, int column, int columns) {
  const int index = row * columns + column;
  return static_cast<std::size_t>(index);
}

}  // namespace synthetic_dataset::randomize

#pragma once

#include <cstddef>

namespace synthetic_dataset::randomize {

/// Where an entry of a table lies whose rows follow one another.
[[nodiscard]] inline std::size_t flatIndex(int row, int column, int columns) {
  const int index = row * columns + column;
  return static_cast<std::size_t>(index);
}

}  // namespace synthetic_dataset::randomize

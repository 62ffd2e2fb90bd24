#include "randomize/appearance/natural/cells.h"

#include <algorithm>

#include "randomize/appearance/natural/noise_table.h"
#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {

Cells::Cells(const Surface& surface, const Laying& laying, base::RandomSource& random)
    : side_(surface.side),
      step_(surface.noiseStep()),
      wobble_(laying.wobble),
      across_(divided(side_, laying.columns, laying.joint)),
      along_(divided(side_, laying.rows, laying.joint)),
      columns_(laying.columns) {
  for (int row = 0; row < laying.rows; ++row) {
    const int fixed = row % 2 == 0 ? 0 : side_ * laying.shift / (256 * laying.columns);
    shifts_.push_back(laying.is_random ? below(random, side_) : fixed);
  }
  for (int i = 0; i < laying.rows * laying.columns; ++i) {
    hashes_.push_back(static_cast<std::uint32_t>(random.bits() >> 32U));
  }
}

std::vector<Cells::Span> Cells::divided(int side, int cells, int joint) {
  std::vector<Span> spans;
  for (int i = 0; i < side; ++i) {
    const int cell = i * cells / side;
    const int first = (cell * side + cells - 1) / cells;
    const int last = ((cell + 1) * side + cells - 1) / cells - 1;
    spans.push_back({cell, std::min(i - first, last - i) - joint});
  }
  // Moves joints away from the border, where one would look like a seam.
  std::rotate(spans.begin(), spans.begin() + side / (2 * cells), spans.end());
  return spans;
}

CellPlace Cells::at(int x, int y) const {
  int moved_x = x;
  int moved_y = y;
  if (wobble_ > 0) {
    const NoiseTable& uneven = noise(Waves::kMedium);
    moved_x += uneven.at(x * step_, y * step_) * wobble_ >> 6;
    moved_y += uneven.at(x * step_ + 200, y * step_ + 300) * wobble_ >> 6;
  }
  const Span& row = along_[static_cast<std::size_t>(moved_y & (side_ - 1))];
  moved_x += shifts_[static_cast<std::size_t>(row.cell)];
  const Span& column = across_[static_cast<std::size_t>(moved_x & (side_ - 1))];
  return {hashes_[static_cast<std::size_t>(row.cell) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column.cell)],
          std::min(row.border, column.border)};
}

}  // namespace synthetic_dataset::randomize::natural

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random/random_source.h"
#include "randomize/appearance/natural/surface_tile.h"

namespace synthetic_dataset::randomize::natural {

/// How bricks, tiles or planks are laid. Rows and columns divide a surface evenly.
struct Laying {
  int rows = 1;  ///< even if `shift` is half a cell
  int columns = 1;
  int shift = 0;           ///< of every second row, in 1/256 of a cell's width
  bool is_random = false;  ///< each row has its own random shift
  int joint = 1;           ///< half the width of a joint [px]
  int wobble = 0;          ///< how uneven edges are: 0 .. 4 [px]
};

/// Where a pixel is in its cell.
struct CellPlace {
  std::uint32_t hash;  ///< random number of the cell
  int border;          ///< distance from the joint [px]; negative inside it
};

/// A surface that is divided into cells.
class Cells {
 public:
  Cells(const Surface& surface, const Laying& laying, base::RandomSource& random);

  [[nodiscard]] CellPlace at(int x, int y) const;

 private:
  struct Span {
    int cell;
    int border;
  };
  [[nodiscard]] static std::vector<Span> divided(int side, int cells, int joint);

  int side_;
  int step_;
  int wobble_;
  std::vector<Span> across_;
  std::vector<Span> along_;
  std::vector<int> shifts_;  ///< of each row [px]
  int columns_;
  std::vector<std::uint32_t> hashes_;  ///< of each cell, row by row
};

}  // namespace synthetic_dataset::randomize::natural

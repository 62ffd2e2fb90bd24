#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/surface_tile.h"

/// Surfaces of various materials, each with many possible looks. All tile seamlessly.
namespace synthetic_dataset::randomize::natural {

// Laid or cast: surfaces_built.cpp.
[[nodiscard]] Surface brick(base::RandomSource& random, int bits);
[[nodiscard]] Surface tiles(base::RandomSource& random, int bits);
[[nodiscard]] Surface concrete(base::RandomSource& random, int bits);
[[nodiscard]] Surface asphalt(base::RandomSource& random, int bits);
[[nodiscard]] Surface plaster(base::RandomSource& random, int bits);

// Grown or weathered: surfaces_grown.cpp.
[[nodiscard]] Surface grass(base::RandomSource& random, int bits);
[[nodiscard]] Surface foliage(base::RandomSource& random, int bits);
[[nodiscard]] Surface gravel(base::RandomSource& random, int bits);
[[nodiscard]] Surface rock(base::RandomSource& random, int bits);
[[nodiscard]] Surface bark(base::RandomSource& random, int bits);

// Manufactured: surfaces_made.cpp.
[[nodiscard]] Surface wood(base::RandomSource& random, int bits);
[[nodiscard]] Surface cloth(base::RandomSource& random, int bits);
[[nodiscard]] Surface metal(base::RandomSource& random, int bits);
[[nodiscard]] Surface print(base::RandomSource& random, int bits);
[[nodiscard]] Surface leaves(base::RandomSource& random, int bits);

/// Turns a surface into a tile, as used by scenes.
[[nodiscard]] inline Tile tileOf(const Surface& surface, base::RandomSource& random) {
  return {surface.bits, litPixels(surface, random)};
}

}  // namespace synthetic_dataset::randomize::natural

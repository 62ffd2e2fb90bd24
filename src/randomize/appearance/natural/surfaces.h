#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/surface_tile.h"

/// Surfaces of materials, each of many looks. All repeat without a seam.
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

// Made by people: surfaces_made.cpp.
[[nodiscard]] Surface wood(base::RandomSource& random, int bits);
[[nodiscard]] Surface cloth(base::RandomSource& random, int bits);
[[nodiscard]] Surface metal(base::RandomSource& random, int bits);
[[nodiscard]] Surface print(base::RandomSource& random, int bits);
[[nodiscard]] Surface leaves(base::RandomSource& random, int bits);

/// What scenes are made of.
[[nodiscard]] inline Tile tileOf(const Surface& surface, base::RandomSource& random) {
  return {surface.bits, litPixels(surface, random)};
}

}  // namespace synthetic_dataset::randomize::natural

#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/surface_tile.h"

/// Marks on surfaces that repeat: whatever crosses a border continues on the other side.
namespace synthetic_dataset::randomize::natural {

/// An ellipse on a surface.
struct Stone {
  int x = 0;
  int y = 0;
  double radius = 1.0;  ///< the larger one [px]
  double flat = 1.0;    ///< the smaller one, as a fraction of the larger
  double turn_x = 1.0;  ///< direction of the longer axis, a unit vector
  double turn_y = 0.0;
  int tone = 128;   ///< in the middle
  int shade = 40;   ///< how much darker the rim is
  int height = 96;  ///< of the middle above the rim
};

/// Draws a unit vector with a random direction.
void drawTurn(base::RandomSource& random, double& x, double& y);

void addStone(Surface& surface, const Stone& stone);

/// An axis-aligned rectangle of a single tone and height.
struct Block {
  int x = 0;
  int y = 0;
  int width = 1;
  int height = 1;
};
void addBlock(Surface& surface, const Block& block, int tone);

/// Adds a line that wanders like a crack, darker and deeper than its surroundings.
void addCrack(Surface& surface, base::RandomSource& random, int length);

/// Adds scattered pixels.
void addSpecks(Surface& surface, base::RandomSource& random, int count, int tone, int spread);

}  // namespace synthetic_dataset::randomize::natural

#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/surface_tile.h"

/// What is drawn on surfaces that repeat: beyond a border it goes on at the other side.
namespace synthetic_dataset::randomize::natural {

/// An ellipse on a surface.
struct Stone {
  int x = 0;
  int y = 0;
  double radius = 1.0;  ///< the greater one [px]
  double flat = 1.0;    ///< the smaller one, as a share of the greater
  double turn_x = 1.0;  ///< the longer axis' direction, a unit vector
  double turn_y = 0.0;
  int tone = 128;   ///< in its middle
  int shade = 40;   ///< how much darker the rim is
  int height = 96;  ///< of its middle over the rim
};

/// A unit vector in any direction.
void drawTurn(base::RandomSource& random, double& x, double& y);

void addStone(Surface& surface, const Stone& stone);

/// A rectangle along the axes, of one tone and height.
struct Block {
  int x = 0;
  int y = 0;
  int width = 1;
  int height = 1;
};
void addBlock(Surface& surface, const Block& block, int tone);

/// A line that wanders, as cracks do, darker and deeper than what is around it.
void addCrack(Surface& surface, base::RandomSource& random, int length);

/// Pixels here and there.
void addSpecks(Surface& surface, base::RandomSource& random, int count, int tone, int spread);

}  // namespace synthetic_dataset::randomize::natural

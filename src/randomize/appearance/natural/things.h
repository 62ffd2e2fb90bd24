#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/canvas.h"

/// Things that stand around in scenes.
namespace synthetic_dataset::randomize::natural {

/// Where something stands in a picture.
struct Standing {
  Point foot;         ///< [px]
  double metre = 10;  ///< [px]
  Colour haze;
  int haze_share = 0;  ///< in 1/256
  int sun = 1;         ///< light comes from the left (-1) or the right (1)
};

/// The materials that things are made of.
struct SceneMaterials {
  std::vector<Tile> crowns;  ///< of trees
  std::vector<Tile> trunks;
  std::vector<Tile> plain;    ///< for anything
  std::vector<Tile> printed;  ///< for signs and posters
};
enum class Whereabouts { kOutdoors, kIndoors };
[[nodiscard]] SceneMaterials drawSceneMaterials(base::RandomSource& random,
                                                Whereabouts where = Whereabouts::kOutdoors);

[[nodiscard]] const Tile& oneOf(const std::vector<Tile>& tiles, base::RandomSource& random);

[[nodiscard]] Point drawnTurn(base::RandomSource& random);

/// The paint of something that stands at a place: from a tile, with `scale` tile pixels for each
/// canvas pixel, or of a single colour.
[[nodiscard]] Paint standingPaint(const Tile& tile, base::RandomSource& random, double scale,
                                  const Standing& at);
[[nodiscard]] Paint colourPaint(const Tile& colour, const Standing& at);

// Grown: things_grown.cpp.
void addTree(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
             base::RandomSource& random);
void addBush(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
             base::RandomSource& random);

// For streets: things_built.cpp.

/// A wall with windows.
[[nodiscard]] Tile drawFacade(base::RandomSource& random);
void addPole(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
             base::RandomSource& random);
void addCar(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
            base::RandomSource& random);
void addFence(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
              base::RandomSource& random);

// Anywhere: things.cpp.

/// A box, a barrel, a ball or a slab, from 0.3 to 1.5 m.
void addThing(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
              base::RandomSource& random);

/// Adds the dark area below something.
void addShadow(Canvas& canvas, const Standing& at, double wide);

/// Fills a polygon with 3 to 9 corners, or a shape with a smooth outline.
void fillShape(Canvas& canvas, const Point& middle, double radius, const Paint& paint,
               base::RandomSource& random);

}  // namespace synthetic_dataset::randomize::natural

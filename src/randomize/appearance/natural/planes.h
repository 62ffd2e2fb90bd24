#pragma once

#include <vector>

#include "randomize/appearance/natural/canvas.h"

/// Large planes in perspective: a sky, a ground, walls along a street.
namespace synthetic_dataset::randomize::natural {

/// A line on the ground that follows the way.
struct Marking {
  double offset = 0.0;  ///< from the way's middle [m]
  double width = 0.12;  ///< [m]
  double dash = 0.0;    ///< length of the dashes and of the gaps [m]; 0 for an unbroken line
  Colour colour{230, 235, 235};
};

/// The view of a plane from a camera 1.5 m above it, or as high as `height`.
struct Ground {
  const Tile* tile = nullptr;
  const Tile* way = nullptr;  ///< of a road or a path; null if there is none
  double horizon = 0.0;       ///< [px]; may be outside the picture
  int first = 0;              ///< first row to be filled [px]
  double focal = 500.0;       ///< [px]
  double height = 1.5;        ///< [m]
  double middle = 0.0;        ///< of the way, at its start [m]
  double half_width = 2.0;    ///< of the way [m]
  double slant = 0.0;         ///< shift to the right for each metre ahead
  double curve = 0.0;         ///< [1/m]
  double texel = 0.01;        ///< [m]
  std::vector<Marking> markings;
  Colour haze;
  double haze_distance = 1e9;  ///< at which half of the light comes from the air [m]
  int patches = 40;            ///< variation in brightness from place to place
};
void fillGround(Canvas& canvas, const Ground& ground, base::RandomSource& random);

/// The sky down to a given row.
struct Sky {
  Colour zenith;
  Colour horizon;
  Colour cloud;
  int cover = 0;  ///< 0 for a clear sky; 256 for an overcast one
};
[[nodiscard]] Sky drawSky(base::RandomSource& random);
void fillSky(Canvas& canvas, const Sky& sky, int horizon, base::RandomSource& random);

/// Something far away whose outline is seen against the sky.
struct Ridge {
  double foot = 0.0;    ///< [px]
  double height = 0.0;  ///< [px]
  int zoom = 64;        ///< places of the noise per pixel, in 1/256: few for hills, many for woods
  Waves waves = Waves::kBroad;
};
void fillRidge(Canvas& canvas, const Ridge& ridge, Paint paint, base::RandomSource& random);

/// An upright wall with vertical left and right edges.
struct Wall {
  double left = 0.0;  ///< [px]
  double right = 0.0;
  double top_left = 0.0;
  double top_right = 0.0;
  double bottom_left = 0.0;
  double bottom_right = 0.0;
  double repeats = 1.0;        ///< of the tile from left to right
  double repeats_along = 1.0;  ///< from top to bottom
  int light = 256;
  Colour haze;
  int haze_left = 0;  ///< in 1/256
  int haze_right = 0;
};
void fillWall(Canvas& canvas, const Wall& wall, const Tile& tile);

}  // namespace synthetic_dataset::randomize::natural

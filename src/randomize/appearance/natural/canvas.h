#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "base/random/random_source.h"
#include "randomize/appearance/natural/natural_colour.h"
#include "randomize/appearance/natural/surface_tile.h"

namespace synthetic_dataset::randomize::natural {

using Canvas = cv::Mat_<cv::Vec4b>;

/// On a canvas [px]: x to the right, y down, whole numbers at pixels' corners.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// With what a shape is filled.
struct Paint {
  const Tile* tile = nullptr;  ///< none: what is there is lit anew, as by a shadow
  int level = 0;               ///< of the tile
  /// The tile's place at the canvas' first pixel and its steps [1/65536 px]; they wrap around.
  std::uint32_t u = 0;
  std::uint32_t v = 0;
  std::uint32_t u_x = 65536;
  std::uint32_t v_x = 0;
  std::uint32_t u_y = 0;
  std::uint32_t v_y = 65536;
  int light = 256;   ///< at the middle; 256: as the tile is
  int light_x = 0;   ///< more of it for each pixel to the right [1/256]
  int light_y = 0;   ///< and down
  int middle_x = 0;  ///< where the light is as given [px]
  int middle_y = 0;
  int round = 0;       ///< how much darker both ends of a row are, as of a trunk: 0 .. 256
  Colour haze;         ///< the air's colour
  int haze_share = 0;  ///< of 256
};

/// A tile as it lies on a surface that is seen from the front.
/// @param scale  the tile's pixels for each of the canvas
/// @param turn  where the tile's x points, a unit vector
[[nodiscard]] Paint paintOf(const Tile& tile, base::RandomSource& random, double scale,
                            const Point& turn = {1.0, 0.0});

/// @param points  of a polygon of any form, at most 64
void fillPolygon(Canvas& canvas, const std::vector<Point>& points, const Paint& paint);

void fillRectangle(Canvas& canvas, const Point& low, const Point& high, const Paint& paint);

/// A line with square ends.
void fillLine(Canvas& canvas, const Point& from, const Point& to, double width_from,
              double width_to, const Paint& paint);

/// @param turn  where the longer axis points, a unit vector
void fillEllipse(Canvas& canvas, const Point& middle, double wide, double high, const Paint& paint,
                 const Point& turn = {1.0, 0.0});

/// A lump with a ragged edge, as crowns of trees, bushes, rocks and stains have.
/// @param wide, high  half of its size [px]
/// @param ragged  0: an ellipse; 256: all shreds
/// @param zoom  places of the noise for each pixel, in 1/256
struct Blob {
  Point middle;
  double wide = 1.0;
  double high = 1.0;
  int ragged = 128;
  int zoom = 256;
  int shift = 0;   ///< which part of the noise it has
  int clumps = 0;  ///< how much lighter and darker its parts are: 0 .. 256
};
void fillBlob(Canvas& canvas, const Blob& blob, const Paint& paint);

/// An ellipse without an edge: a shadow, a glow, or something far out of focus.
/// @param opacity  in the middle, 0 .. 256
void addHaze(Canvas& canvas, const Point& middle, double wide, double high, const Colour& colour,
             int opacity);

}  // namespace synthetic_dataset::randomize::natural

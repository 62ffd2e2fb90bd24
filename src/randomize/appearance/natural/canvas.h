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

/// A place on a canvas [px]: x to the right, y down, integers at pixel corners.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// What a shape is filled with.
struct Paint {
  const Tile* tile = nullptr;  ///< null: only changes the light on what is there, like a shadow
  int level = 0;               ///< mipmap level of the tile
  /// The tile's place at the canvas's first pixel, and its steps [1/65536 px]; they wrap around.
  std::uint32_t u = 0;
  std::uint32_t v = 0;
  std::uint32_t u_x = 65536;
  std::uint32_t v_x = 0;
  std::uint32_t u_y = 0;
  std::uint32_t v_y = 65536;
  int light = 256;   ///< at the middle; 256 for the tile's own
  int light_x = 0;   ///< change for each pixel to the right [1/256]
  int light_y = 0;   ///< change for each pixel down [1/256]
  int middle_x = 0;  ///< where `light` applies [px]
  int middle_y = 0;
  int round = 0;       ///< how much darker both ends of a row are, as on a trunk: 0 .. 256
  Colour haze;         ///< colour of the air
  int haze_share = 0;  ///< in 1/256
};

/// A tile on a surface that faces the viewer.
/// @param scale  tile pixels per canvas pixel
/// @param turn  direction of the tile's x, a unit vector
[[nodiscard]] Paint paintOf(const Tile& tile, base::RandomSource& random, double scale,
                            const Point& turn = {1.0, 0.0});

/// @param points  of a polygon of any shape, at most 64
void fillPolygon(Canvas& canvas, const std::vector<Point>& points, const Paint& paint);

void fillRectangle(Canvas& canvas, const Point& low, const Point& high, const Paint& paint);

/// A line with square ends.
void fillLine(Canvas& canvas, const Point& from, const Point& to, double width_from,
              double width_to, const Paint& paint);

/// @param turn  direction of the first axis, a unit vector
void fillEllipse(Canvas& canvas, const Point& middle, double wide, double high, const Paint& paint,
                 const Point& turn = {1.0, 0.0});

/// A lump with a ragged edge, like the crowns of trees, bushes, rocks and stains.
/// @param wide, high  half of its size [px]
/// @param ragged  0 for an ellipse; 256 for nothing but shreds
/// @param zoom  places of the noise per pixel, in 1/256
struct Blob {
  Point middle;
  double wide = 1.0;
  double high = 1.0;
  int ragged = 128;
  int zoom = 256;
  int shift = 0;   ///< selects a part of the noise
  int clumps = 0;  ///< variation of its brightness: 0 .. 256
};
void fillBlob(Canvas& canvas, const Blob& blob, const Paint& paint);

/// Draws an ellipse without a sharp edge: a shadow, a glow, or something far out of focus.
/// @param opacity  in the middle, 0 .. 256
void addHaze(Canvas& canvas, const Point& middle, double wide, double high, const Colour& colour,
             int opacity);

}  // namespace synthetic_dataset::randomize::natural

#pragma once

#include <algorithm>

#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// Where four directions lie in a panorama, 0 .. 1 from the left and from the top.
struct PanoramaPlaces {
  Lanes x;
  Lanes y;
};

/// @param directions  the panorama's, unit vectors: its upper edge is +z, its middle +x, to the
///     right of which is -y
[[nodiscard]] PanoramaPlaces placesOf(const Lanes3& directions);

/// A panorama with one pixel more at each edge, which is what lies beyond: around the world, and
/// past the poles on their other side.
[[nodiscard]] cv::Mat bordered(const cv::Mat& panorama);

/// The upper left one of four pixels between whose centres a place lies, and how far from it.
struct PixelsAround {
  int row;
  int column;
  float right;  ///< 0 .. 1
  float down;
};

/// @param map  of bordered()
/// @param x, y  of PanoramaPlaces
[[nodiscard]] inline PixelsAround pixelsAround(const cv::Mat& map, float x, float y) {
  // The first pixel is what lies beyond the edge, and a pixel's centre is half past.
  const float column = x * static_cast<float>(map.cols - 2) + 0.5F;
  const float row = y * static_cast<float>(map.rows - 2) + 0.5F;
  PixelsAround around{};
  around.column = std::min(static_cast<int>(column), map.cols - 2);
  around.row = std::min(static_cast<int>(row), map.rows - 2);
  around.right = column - static_cast<float>(around.column);
  around.down = row - static_cast<float>(around.row);
  return around;
}

}  // namespace synthetic_dataset::render

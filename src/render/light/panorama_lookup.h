#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// The places of four directions in a panorama, 0 .. 1 from the left and from the top.
struct PanoramaPlaces {
  Lanes x;
  Lanes y;
};

/// @param directions  unit vectors in the panorama's frame: its upper edge is +z, its middle is +x,
///     with -y to the right of it
[[nodiscard]] PanoramaPlaces placesOf(const Lanes3& directions);

/// A panorama with one more pixel at each edge, which shows what lies beyond: horizontally the
/// opposite edge, vertically what lies on the other side of the pole.
[[nodiscard]] cv::Mat bordered(const cv::Mat& panorama);

/// The upper left of the four pixels between whose centres a place lies, and how far from it that
/// is.
struct PixelsAround {
  int row;
  int column;
  float right;  ///< 0 .. 1
  float down;
};

/// @param map  made by bordered()
/// @param x, y  as in PanoramaPlaces
[[nodiscard]] inline PixelsAround pixelsAround(const cv::Mat& map, float x, float y) {
  // The first pixel lies beyond the edge, and a pixel's centre is half a pixel from its edge.
  const float column = x * static_cast<float>(map.cols - 2) + 0.5F;
  const float row = y * static_cast<float>(map.rows - 2) + 0.5F;
  PixelsAround around{};
  around.column = std::min(static_cast<int>(column), map.cols - 2);
  around.row = std::min(static_cast<int>(row), map.rows - 2);
  around.right = column - static_cast<float>(around.column);
  around.down = row - static_cast<float>(around.row);
  return around;
}

/// The light at four places, each interpolated between four pixels of a map of its own.
/// @tparam Pixel  of the maps
/// @param mapOf  returns a lane's map, made by bordered()
/// @param load  loads four consecutive pixels as light
template <class Pixel, class MapOf, class Load>
[[nodiscard]] Lanes3 seenBetween(const PanoramaPlaces& places, const MapOf& mapOf,
                                 const Load& load) {
  alignas(16) std::array<float, kLaneCount> x{};
  alignas(16) std::array<float, kLaneCount> y{};
  cv::v_store(x.data(), places.x);
  cv::v_store(y.data(), places.y);
  std::array<std::array<Pixel, kLaneCount>, 4> corners;
  std::array<float, kLaneCount> right{};
  std::array<float, kLaneCount> down{};
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const cv::Mat& map = mapOf(i);
    const PixelsAround around = pixelsAround(map, x[i], y[i]);
    right[i] = around.right;
    down[i] = around.down;
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      corners[corner][i] = map.at<Pixel>(around.row + static_cast<int>(corner / 2),
                                         around.column + static_cast<int>(corner % 2));
    }
  }
  const auto pixel = [&](std::size_t corner) -> Lanes3 { return load(corners[corner][0].val); };
  const Lanes to_right = cv::v_load(right.data());
  return mix(mix(pixel(0), pixel(1), to_right), mix(pixel(2), pixel(3), to_right),
             cv::v_load(down.data()));
}

}  // namespace synthetic_dataset::render

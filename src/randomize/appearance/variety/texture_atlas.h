#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A mesh on which every place has a texel of its own.
struct UnwrappedSurface {
  std::shared_ptr<const world::Mesh> mesh;  ///< the same triangles, in the same order
  cv::Mat picture;                          ///< CV_8UC4: the look of the original surface
};

/// Lays out a surface's triangles in a new picture. Connected triangles that mostly face along the
/// same axis stay together, seen along that axis. For surfaces without a texture, and for those
/// that show the same texels in several places.
/// @param side  of the picture, a power of two [px]
/// @return nothing if too much of the surface would overlap
[[nodiscard]] std::optional<UnwrappedSurface> unwrapped(const world::Surface& surface, int side);

/// A picture's colour at repeating texture coordinates, interpolated between its pixels.
[[nodiscard]] cv::Vec4b texelAt(const cv::Mat& pixels, const Eigen::Vector2f& place);

/// The place in a texture that coordinates refer to.
[[nodiscard]] inline Eigen::Vector2f texturePlace(const world::Material& material,
                                                  const Eigen::Vector2f& coordinates) {
  return coordinates.cwiseProduct(material.texture_scale) + material.texture_offset;
}

}  // namespace synthetic_dataset::randomize

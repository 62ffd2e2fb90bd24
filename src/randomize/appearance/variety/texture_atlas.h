#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A mesh whose every place has a texel of its own.
struct UnwrappedSurface {
  std::shared_ptr<const world::Mesh> mesh;  ///< the same triangles, in the same order
  cv::Mat picture;                          ///< CV_8UC4: how the surface looked
};

/// Lays a surface's triangles out in a new picture, those together that hang together and mostly
/// face along the same axis, from which they are seen. For surfaces without a texture, and for
/// those of which several places show the same texels.
/// @param side  of the picture, a power of two [px]
/// @return nothing where too much lies behind one another to be laid out so
[[nodiscard]] std::optional<UnwrappedSurface> unwrapped(const world::Surface& surface, int side);

/// A picture's colour at texture coordinates that repeat, between its pixels.
[[nodiscard]] cv::Vec4b texelAt(const cv::Mat& pixels, const Eigen::Vector2f& place);

/// Where a texture's coordinates are in it.
[[nodiscard]] inline Eigen::Vector2f texturePlace(const world::Material& material,
                                                  const Eigen::Vector2f& coordinates) {
  return coordinates.cwiseProduct(material.texture_scale) + material.texture_offset;
}

}  // namespace synthetic_dataset::randomize

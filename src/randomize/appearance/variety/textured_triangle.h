#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "randomize/appearance/variety/flat_index.h"
#include "randomize/appearance/variety/model_parts.h"
#include "randomize/appearance/variety/texture_atlas.h"

namespace synthetic_dataset::randomize {

/// A triangle that shows a part of a picture.
struct TexturedTriangle {
  /// @param first  index of its first corner in the mesh's indices
  TexturedTriangle(const world::Surface& surface, const SurfacePart& part, std::size_t first,
                   const cv::Mat& picture) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t vertex = surface.mesh->indices[first + c];
      const Eigen::Vector2f place =
          texturePlace(surface.material, surface.mesh->texture_coordinates[vertex]);
      corners[c] = place.cast<double>().cwiseProduct(Eigen::Vector2d(picture.cols, picture.rows));
      p_M.col(static_cast<Eigen::Index>(c)) = part.p_M[vertex];
    }
  }

  std::array<Eigen::Vector2d, 3> corners;  ///< in texels, as for forEachTexel
  Eigen::Matrix3d p_M;                     ///< of the corners, one per column
};

/// The index of a texel in a picture that repeats.
[[nodiscard]] inline std::size_t wrappedIndex(int column, int row, const cv::Mat& picture) {
  const auto wrapped = [](int index, int count) { return ((index % count) + count) % count; };
  return flatIndex(wrapped(row, picture.rows), wrapped(column, picture.cols), picture.cols);
}

}  // namespace synthetic_dataset::randomize

#pragma once

#include <cstddef>

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::programs {

/// What there is to see of a model.
struct ModelCounts {
  std::size_t links = 0;
  std::size_t visuals = 0;
  std::size_t surfaces = 0;
  std::size_t triangles = 0;
  std::size_t textures = 0;  ///< different pictures, of all kinds
};

[[nodiscard]] ModelCounts countModels(const world::Description& description);

/// Round all that is seen of the models where their files place them; empty if nothing is.
[[nodiscard]] Eigen::AlignedBox3d visibleBounds(const world::Description& description);

/// A view from the front (+x), the right and above that just holds a box of any size and shape.
/// @param bounds_W  not empty
[[nodiscard]] render::View portraitView(const Eigen::AlignedBox3d& bounds_W, const cv::Size& size);

/// A picture of the models alone on a plain ground, in the sun; CV_8UC3. An empty matrix if there
/// is nothing to see.
[[nodiscard]] cv::Mat portray(const world::Description& description, const cv::Size& size);

}  // namespace synthetic_dataset::programs

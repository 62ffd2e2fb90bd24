#pragma once

#include <cstddef>

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::run {

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

/// The same of one model that stands at `X_AM`, along the axes of A.
[[nodiscard]] Eigen::AlignedBox3d visibleBounds(const world::Model& model, const Pose& X_AM);

/// From the front (+x), the right and above.
[[nodiscard]] inline Eigen::Vector3d usualDirection() { return {-1.0, 0.75, -0.62}; }

/// From where one stands at a longitude about z, 0 on +x, and a latitude, and looks at the middle
/// [rad]; straight from above and below as far as that has an upright.
[[nodiscard]] Eigen::Vector3d directionFrom(double longitude, double latitude);

/// A view that just holds a box of any size and shape.
/// @param bounds_W  not empty
/// @param ahead_W  which way it looks, of any length; not along z
[[nodiscard]] render::View portraitView(const Eigen::AlignedBox3d& bounds_W, const cv::Size& size,
                                        const Eigen::Vector3d& ahead_W = usualDirection());

/// A picture of the models alone on a plain ground, in the sun; CV_8UC3. An empty matrix if there
/// is nothing to see.
[[nodiscard]] cv::Mat portray(const world::Description& description, const cv::Size& size,
                              const Eigen::Vector3d& ahead_W = usualDirection());

}  // namespace synthetic_dataset::run

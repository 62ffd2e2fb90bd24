#pragma once

#include <cstddef>

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::run {

/// Counts of a model's visible parts.
struct ModelCounts {
  std::size_t links = 0;
  std::size_t visuals = 0;
  std::size_t surfaces = 0;
  std::size_t triangles = 0;
  std::size_t textures = 0;  ///< distinct pictures, of all kinds
};

[[nodiscard]] ModelCounts countModels(const world::Description& description);

/// Bounds of everything visible of the models where their files place them; empty if nothing is
/// visible.
[[nodiscard]] Eigen::AlignedBox3d visibleBounds(const world::Description& description);

/// Visible bounds of one model that stands at `X_AM`, along the axes of A.
[[nodiscard]] Eigen::AlignedBox3d visibleBounds(const world::Model& model, const Pose& X_AM);

/// The view direction from the front (+x), the right and above.
[[nodiscard]] inline Eigen::Vector3d usualDirection() { return {-1.0, 0.75, -0.62}; }

/// The view direction towards the centre from a longitude about z (0 on +x) and a latitude [rad],
/// limited just short of straight up and down, where the view has no upright.
[[nodiscard]] Eigen::Vector3d directionFrom(double longitude, double latitude);

/// A view that tightly frames a box of any size and shape.
/// @param bounds_W  not empty
/// @param ahead_W  which way it looks, of any length; not along z
[[nodiscard]] render::View portraitView(const Eigen::AlignedBox3d& bounds_W, const cv::Size& size,
                                        const Eigen::Vector3d& ahead_W = usualDirection());

/// A picture of nothing but the models on a plain ground, in sunlight; CV_8UC3. An empty matrix if
/// there is nothing to see.
[[nodiscard]] cv::Mat portray(const world::Description& description, const cv::Size& size,
                              const Eigen::Vector3d& ahead_W = usualDirection());

}  // namespace synthetic_dataset::run

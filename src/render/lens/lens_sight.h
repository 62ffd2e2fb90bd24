#pragma once

#include <array>
#include <memory>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/lens/lens_map.h"
#include "render/lens/ray_raster.h"
#include "render/lens/row_poses.h"
#include "render/lens/surface_point.h"
#include "render/parts/item_surface.h"

namespace synthetic_dataset::render {

/// What the rays of a lens's pixels see: each its own, not a neighbour's.
struct LensSight {
  std::shared_ptr<const LensMap> lens;
  cv::Mat items;      ///< CV_32SC1: the number of what is seen in the draw list, 0 for nothing
  cv::Mat triangles;  ///< CV_32SC1: its index in `seen`, -1 for nothing
  cv::Mat distance;   ///< CV_32FC1: along the ray [m], 0 for nothing
  std::vector<SeenTriangle> seen;
  std::vector<Pose> X_CV;  ///< of each item, by its number
  std::shared_ptr<const std::vector<ItemSurface>> surfaces;
  std::shared_ptr<const RowPoses> rows = nullptr;  ///< where rows are taken one after the other

  /// X_CV of its item, at the time of its row where that has one.
  [[nodiscard]] Pose poseOf(const SeenTriangle& triangle) const;

  [[nodiscard]] std::array<Eigen::Vector3d, 3> cornersOf(const SeenTriangle& triangle) const;
  [[nodiscard]] FacedTriangle triangleAt(int index) const;
};

/// Whether items with holes have one where a ray meets them; textures are looked up as for pictures
/// of the lens's faces.
/// @param surfaces  by the items' numbers
[[nodiscard]] RayRaster::IsHole holesIn(
    const DrawList& draw_list, const std::shared_ptr<const std::vector<ItemSurface>>& surfaces);

/// Where a ray meets the triangle's plane: how far away, in the ray's length.
[[nodiscard]] double distanceTo(const std::array<Eigen::Vector3d, 3>& corners,
                                const Eigen::Vector3d& ray);

}  // namespace synthetic_dataset::render

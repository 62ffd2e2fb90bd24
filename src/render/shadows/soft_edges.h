#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"
#include "render/shadows/map_depths.h"

namespace synthetic_dataset::render {

/// A place in a shadow map, and the slope of the surface there.
struct PlaceInMap {
  float column, row;  ///< [texel]
  float depth;
  float depth_by_column;  ///< by how much the surface's depth grows from texel to texel
  float depth_by_row;
};

/// The edges of shadows in the light of a disc: sharp at the base of a caster, soft far from it
/// (percentage-closer soft shadows; Fernando 2005).
///
/// Occluders of the disc are searched for in cells of texels, as far around as they may be; their
/// distance from the surface determines how much of the map the disc covers.
class SoftEdges {
 public:
  /// @param depths  with MapDepths::Assembled::nearest(); have to outlive this object
  /// @param softness  as in ShadowProjection
  SoftEdges(const MapDepths::Assembled& depths, const Eigen::Vector2d& softness)
      : depths_(depths.depths()), nearest_(depths.nearest()), softness_(softness.cast<float>()) {}

  /// The share of the light that passes, from 0 to 1.
  [[nodiscard]] float passing(const PlaceInMap& place) const;

 private:
  [[nodiscard]] Eigen::Vector2f discOf(float depth) const;
  [[nodiscard]] float gapBefore(const PlaceInMap& place) const;
  [[nodiscard]] float sharp(const PlaceInMap& place) const;
  [[nodiscard]] float soft(const PlaceInMap& place, const Eigen::Vector2f& disc) const;

  const cv::Mat& depths_;
  const cv::Mat& nearest_;
  Eigen::Vector2f softness_;
};

}  // namespace synthetic_dataset::render

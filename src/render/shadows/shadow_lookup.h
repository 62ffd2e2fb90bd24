#pragma once

#include <optional>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"
#include "render/shadows/map_depths.h"
#include "render/shadows/soft_edges.h"

namespace synthetic_dataset::render {

/// A shadow map, and how it was drawn.
struct CastShadow {
  MapDepths map;
  Eigen::Matrix4d shadow_from_camera;  ///< to clip coordinates of the map: -1 to 1, depth 0 to 1
  double texel;                        ///< as in ShadowProjection
  Eigen::Vector2d softness;            ///< as in ShadowProjection

  [[nodiscard]] bool isSoft() const { return !softness.isZero(); }
};

/// Looks up the share of a light that is not shadowed.
class ShadowLookup {
 public:
  /// @param depths  of the map; have to outlive this object
  /// @param from_point  whether the light comes from a point
  ShadowLookup(const CastShadow& shadow, const MapDepths::Assembled& depths, bool from_point);

  /// How far in front of the light points are [m], along the map's axis; below 0 behind it.
  [[nodiscard]] Lanes ahead(const Lanes3& position_C) const;

  /// The share of the light that passes, from 0 to 1: the mean over a square of 3 x 3 texels around
  /// the place, in which texels at the rim count by their share; or, if edges are soft, that of
  /// SoftEdges.
  /// @param normal  of the surface, towards the eye
  /// @param n_dot_l  the cosine of the angle between the normal and the direction to the light
  /// @param distance  to the light [m]
  /// @param wanted  a mask: 0 in lanes that do not matter
  [[nodiscard]] Lanes passing(const Lanes3& position_C, const Lanes3& normal, const Lanes& n_dot_l,
                              const Lanes& distance, const Lanes& wanted) const;

 private:
  struct FourInMap;

  [[nodiscard]] FourInMap find(const Lanes3& raised, const Lanes3& normal, const Lanes& n_dot_l,
                               const Lanes& wanted) const;
  [[nodiscard]] float passingAt(float column, float row, float depth) const;

  const cv::Mat& depths_;
  std::size_t row_step_;  ///< [texel]
  float size_;
  float texel_;
  bool from_point_;
  Eigen::Matrix4f map_from_camera_;     ///< to homogeneous column, row, depth
  Eigen::Matrix4f planes_from_camera_;  ///< the same for planes: normal and offset
  std::optional<SoftEdges> soft_edges_;
};

}  // namespace synthetic_dataset::render

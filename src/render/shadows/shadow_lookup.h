#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// What of one light arrives in spite of what stands in its way.
class ShadowLookup {
 public:
  /// @param depths  CV_32FC1, a square: of what is nearest to the light; has to outlive this
  /// @param shadow_from_camera  to clip coordinates of the map: -1 to 1, depth 0 to 1
  /// @param texel  a texel's size [m]; of a light's map, at a distance of 1 m from it
  /// @param is_lamp  whether the light comes from a point
  ShadowLookup(const cv::Mat& depths, const Eigen::Matrix4d& shadow_from_camera, double texel,
               bool is_lamp);

  /// The share of the light that passes, from 0 to 1: the mean over a square of 3 x 3 texels around
  /// the place, whose rim counts by its share.
  /// @param normal  of the surface, towards the eye
  /// @param n_dot_l  the cosine of the angle between it and the way to the light
  /// @param distance  to the light [m]
  /// @param wanted  0 in lanes that do not matter
  [[nodiscard]] Lanes passing(const Lanes3& position_C, const Lanes3& normal, const Lanes& n_dot_l,
                              const Lanes& distance, const Lanes& wanted) const;

 private:
  [[nodiscard]] float passingAt(float column, float row, float depth) const;

  const cv::Mat& depths_;
  std::size_t row_step_;  ///< [texel]
  float size_;
  float texel_;
  bool is_lamp_;
  Eigen::Matrix4f map_from_camera_;  ///< to column, row, depth and 1, all times the last
};

}  // namespace synthetic_dataset::render

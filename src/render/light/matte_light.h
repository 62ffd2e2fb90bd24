#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// What matte surfaces make of the light of a panorama. It varies slowly with their normals, so it
/// is found for some of them and looked up between these. Spherical harmonics of nine numbers would
/// do for skies, but a sun in a panorama would light what is turned away from it.
class MatteLight {
 public:
  /// The light of a panorama's rows from one on to before another, as if the others were black.
  /// @param panorama  CV_32FC4: equirectangular; red, green, blue and any, linear; a multiple of
  ///     four columns
  MatteLight(const cv::Mat& panorama, int first_row, int end_row);

  /// What arrives from the half of the world that surfaces face, as their cosine counts; 1 where
  /// all of it is white.
  /// @param normals  unit vectors of the panorama's frame
  [[nodiscard]] Lanes3 arriving(const Lanes3& normals) const;
  [[nodiscard]] Eigen::Vector3f arriving(const Eigen::Vector3f& normal) const;

  /// The weighted sum of both.
  [[nodiscard]] static MatteLight sum(const MatteLight& first, const Eigen::Vector3f& of_first,
                                      const MatteLight& second, const Eigen::Vector3f& of_second);

 private:
  MatteLight() = default;

  cv::Mat map_;  ///< CV_32FC4: by normals, as a panorama, of bordered()
};

}  // namespace synthetic_dataset::render

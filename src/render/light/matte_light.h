#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// The light of a panorama that arrives at matte surfaces (irradiance). It varies slowly with their
/// normals, so it is computed for some normals and interpolated. Spherical harmonics with nine
/// coefficients would suffice for skies, but with them a sun in a panorama would light what faces
/// away from it.
class MatteLight {
 public:
  /// The light of a panorama's rows from first_row up to but not including end_row.
  /// @param panorama  CV_32FC4: equirectangular; linear red, green, blue and an unused number; its
  ///     width is a multiple of four
  MatteLight(const cv::Mat& panorama, int first_row, int end_row);

  /// The light that arrives from the hemisphere that surfaces face, weighted by the cosine; 1 if
  /// all of it is white.
  /// @param normals  unit vectors in the panorama's frame
  [[nodiscard]] Lanes3 arriving(const Lanes3& normals) const;
  [[nodiscard]] Eigen::Vector3f arriving(const Eigen::Vector3f& normal) const;

  /// The weighted sum of both.
  [[nodiscard]] static MatteLight sum(const MatteLight& first, const Eigen::Vector3f& of_first,
                                      const MatteLight& second, const Eigen::Vector3f& of_second);

 private:
  MatteLight() = default;

  cv::Mat map_;  ///< CV_32FC4: by normals, as a panorama made by bordered()
};

}  // namespace synthetic_dataset::render

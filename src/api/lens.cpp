#include "api/lens.h"

#include <algorithm>
#include <cmath>

#include "api/fisheye_lens.h"
#include "api/lens_model.h"
#include "api/plane_lens.h"
#include "api/sphere_lenses.h"

namespace synthetic_dataset::lens {

const std::vector<LensModel>& allModels() {
  static const std::vector<LensModel> table = {
      {DistortionModel::kNone,
       {"none", "", "pinhole", "perspective", "undistorted", "nodistortion"},
       {0},
       0,
       "no coefficients",
       false,
       &kPinhole},
      {DistortionModel::kPlumbBob,
       {"plumb_bob", "radtan", "radialtangential", "brownconrady"},
       {4, 5},
       5,
       "4 or 5 (k1, k2, p1, p2, k3)",
       false,
       &kBentPinhole},
      {DistortionModel::kRationalPolynomial,
       {"rational_polynomial", "rational", "thinprism", "tilted"},
       {4, 5, 8, 12, 14},
       8,
       "4, 5, 8, 12 or 14 (k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, tau_x, tau_y)",
       false,
       &kBentPinhole},
      {DistortionModel::kEquidistant,
       {"equidistant", "fisheye", "opencvfisheye", "equi", "kannalabrandt", "kannalabrandt4",
        "kannalabrandt8", "kb4"},
       {4},
       4,
       "4 (k1, k2, k3, k4)",
       true,
       &kFisheye},
      {DistortionModel::kOmnidirectional,
       {"omnidirectional", "omni", "omnidir", "mei", "omniradtan"},
       {1, 5, 6},
       5,
       "1, 5 or 6 (xi, k1, k2, p1, p2, skew / fx)",
       false,
       &kOmnidirectionalLens,
       omnidirectionalFault},
      {DistortionModel::kDoubleSphere,
       {"double_sphere", "ds"},
       {2},
       2,
       "2 (xi, alpha)",
       false,
       &kDoubleSphereLens,
       doubleSphereFault},
  };
  return table;
}

const LensModel& modelOf(DistortionModel model) {
  return allModels()[static_cast<std::size_t>(model)];
}

double largestAngle(const Distortion& distortion) {
  constexpr double kStep = 1e-4;  // [rad]
  const LensFunctions& lens = *modelOf(distortion.model).functions;
  const double end = std::min(lens.has_near_plane ? 0.5 * M_PI : M_PI, distortion.cutoff_angle);
  if (distortion.model == DistortionModel::kNone) return end;
  double sound = 0.0;
  while (sound + kStep < end && lens.isOneToOne(distortion, sound + kStep)) sound += kStep;
  if (sound + kStep >= end) return end;
  double folded = sound + kStep;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (sound + folded);
    (lens.isOneToOne(distortion, middle) ? sound : folded) = middle;
  }
  return sound;
}

std::optional<Eigen::Vector2d> distort(const Distortion& distortion, double largest_angle,
                                       const Eigen::Vector3d& direction) {
  return modelOf(distortion.model).functions->distort(distortion, largest_angle, direction);
}

std::optional<Eigen::Vector3d> undistort(const Distortion& distortion, double largest_angle,
                                         const Eigen::Vector2d& place) {
  return modelOf(distortion.model).functions->undistort(distortion, largest_angle, place);
}

}  // namespace synthetic_dataset::lens

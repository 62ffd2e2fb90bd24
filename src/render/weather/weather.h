#pragma once

#include <limits>

#include <Eigen/Core>

namespace synthetic_dataset::render {

/// What is in the air between a camera and what it sees; nothing by default.
struct Weather {
  /// The visibility by day [m], > 0: the meteorological optical range, over which 95 % of the light
  /// is lost (WMO-No. 8).
  double visibility = std::numeric_limits<double>::infinity();

  double rain = 0.0;                      ///< [mm/h]
  double snow = 0.0;                      ///< [mm/h] of melted snow
  Eigen::Vector3d wind_G{0.0, 0.0, 0.0};  ///< [m/s]; drops and flakes drift with it
  Eigen::Vector3f colour = Eigen::Vector3f::Constant(0.75F);  ///< of all these, sRGB-encoded

  [[nodiscard]] bool isClear() const {
    return visibility == std::numeric_limits<double>::infinity() && rain <= 0.0 && snow <= 0.0;
  }
};

/// The aperture of all lenses, which makes near things out of focus [m].
inline constexpr double kLensAperture = 2e-3;

}  // namespace synthetic_dataset::render

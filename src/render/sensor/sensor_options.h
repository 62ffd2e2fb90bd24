#pragma once

#include <limits>

namespace synthetic_dataset::render {

/// The light for which a camera shows the pictures' white as white [K]: that for which they are
/// made.
inline constexpr double kNeutralWhite = 6500.0;

inline constexpr double kReddestLight = 2500.0;  ///< that a camera can be set for [K]
inline constexpr double kBluestLight = 25000.0;  ///< likewise [K]

/// What lens and sensor do to a picture; nothing by default.
struct SensorEffects {
  double exposure = 0.0;  ///< [stops]; the renderer applies it, before it limits what is bright
  double blur = 0.0;      ///< standard deviation of the point spread [px]
  double white_balance = kNeutralWhite;  ///< of the light that the camera is set for [K]
  double vignetting = 0.0;  ///< 0 .. 1: the share of light that the image's corners lack
  double full_well = 0.0;  ///< electrons of a white pixel, whose number is random; 0: no shot noise
  double noise_mean = 0.0;    ///< of a Gaussian added to the values of pixels, of the full scale
  double noise_stddev = 0.0;  ///< of a Gaussian added to the values of pixels, of the full scale
  int jpeg_quality = 0;       ///< with which the camera compresses, 1 .. 100; 0: it does not
};

enum class DepthModel { kExact, kStructuredLight, kStereo };

/// How a depth camera measures; exactly by default.
struct DepthNoise {
  DepthModel model = DepthModel::kExact;
  double baseline = 0.0;         ///< from the camera to its projector, or to the second camera [m]
  double disparity_step = 0.0;   ///< that disparities are rounded to [px]; 0: they are not
  double disparity_noise = 0.0;  ///< standard deviation of a stereo camera's disparities [px]
  double greatest_angle = 0.0;   ///< between ray and normal at which light still returns [rad]
  double min_depth = 0.0;        ///< [m]
  double max_depth = std::numeric_limits<double>::infinity();  ///< [m]
};

}  // namespace synthetic_dataset::render

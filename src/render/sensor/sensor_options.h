#pragma once

#include <limits>

namespace synthetic_dataset::render {

/// The colour temperature for which the pictures are made [K]: a camera set for it shows their
/// white as white.
inline constexpr double kNeutralWhite = 6500.0;

inline constexpr double kReddestLight = 2500.0;  ///< for which a camera can be set [K]
inline constexpr double kBluestLight = 25000.0;  ///< for which a camera can be set [K]

/// The effects of lens and sensor on a picture; none by default.
struct SensorEffects {
  double exposure = 0.0;  ///< [stops]; applied by the renderer before it compresses bright light
  double blur = 0.0;      ///< standard deviation of the point spread [px]
  double white_balance = kNeutralWhite;  ///< of the light for which the camera is set [K]
  double vignetting = 0.0;    ///< 0 .. 1: the share of light that is missing in the image's corners
  double full_well = 0.0;     ///< mean number of electrons of a white pixel; 0: no shot noise
  double noise_mean = 0.0;    ///< of a Gaussian added to pixels' values, as a share of full scale
  double noise_stddev = 0.0;  ///< of a Gaussian added to pixels' values, as a share of full scale
  int jpeg_quality = 0;       ///< of the camera's compression, 1 .. 100; 0: not compressed
};

enum class DepthModel { kExact, kStructuredLight, kStereo };

/// How a depth camera measures; exactly by default.
struct DepthNoise {
  DepthModel model = DepthModel::kExact;
  double baseline = 0.0;         ///< from the camera to its projector, or to the second camera [m]
  double disparity_step = 0.0;   ///< to which disparities are rounded [px]; 0: they are not
  double disparity_noise = 0.0;  ///< standard deviation of a stereo camera's disparities [px]
  double greatest_angle = 0.0;   ///< between ray and normal at which light still returns [rad]
  double min_depth = 0.0;        ///< [m]
  double max_depth = std::numeric_limits<double>::infinity();  ///< [m]
};

}  // namespace synthetic_dataset::render

#pragma once

#include <limits>

namespace synthetic_dataset::render {

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

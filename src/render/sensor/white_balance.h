#pragma once

#include <opencv2/core/matx.hpp>

namespace synthetic_dataset::render {

/// The light for which a camera shows the pictures' white as white [K]: that for which they are
/// made.
inline constexpr double kNeutralWhite = 6500.0;

inline constexpr double kReddestLight = 2500.0;  ///< that a camera can be set for [K]
inline constexpr double kBluestLight = 25000.0;  ///< likewise [K]

/// The factors on linear blue, green and red of a camera that is set for the light of a black body,
/// and sees the pictures' light: bluish for less than 6500 K, reddish for more. The luminance of
/// white stays.
/// @param kelvin  kReddestLight to kBluestLight
[[nodiscard]] cv::Vec3f whiteBalanceGains(double kelvin);

}  // namespace synthetic_dataset::render

#pragma once

#include <opencv2/core/matx.hpp>

namespace synthetic_dataset::render {

/// The factors on linear blue, green and red of a camera that is set for the light of a black body,
/// and sees the pictures' light: bluish for less than 6500 K, reddish for more. The luminance of
/// white stays.
/// @param kelvin  kReddestLight to kBluestLight (sensor_options.h)
[[nodiscard]] cv::Vec3f whiteBalanceGains(double kelvin);

}  // namespace synthetic_dataset::render

#pragma once

#include <opencv2/core/matx.hpp>

namespace synthetic_dataset::render {

/// The factors on linear blue, green and red of a camera that is set for the light of a black body
/// but sees the pictures' light: bluish below 6500 K, reddish above. The luminance of white is
/// preserved.
/// @param kelvin  kReddestLight to kBluestLight (sensor_options.h)
[[nodiscard]] cv::Vec3f whiteBalanceGains(double kelvin);

}  // namespace synthetic_dataset::render

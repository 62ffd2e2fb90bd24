#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/sensor/sensor_options.h"

/// What lens and sensor do to a picture. Plain pictures in, plain pictures out.
namespace synthetic_dataset::render {

/// The factor on all light that is the effects' exposure.
[[nodiscard]] double gainOf(const SensorEffects& effects);

/// Applies what happens behind the shutter, in the order of a camera: blur, vignetting, shot noise
/// and white balance in linear light, Gaussian noise on the encoded values (as SDF's camera noise),
/// then JPEG's compression.
/// @param picture  CV_8UC3, sRGB-encoded; given back as it is where there is nothing to do
/// @param seed  of the noise: the same seed gives the same picture
[[nodiscard]] cv::Mat applyEffects(const cv::Mat& picture, const SensorEffects& effects,
                                   std::uint64_t seed);

}  // namespace synthetic_dataset::render

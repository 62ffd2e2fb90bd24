#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/sensor/sensor_options.h"

/// The effects of lens and sensor on a picture. Plain pictures in, plain pictures out.
namespace synthetic_dataset::render {

/// The factor by which the effects' exposure multiplies all light.
[[nodiscard]] double gainOf(const SensorEffects& effects);

/// Applies what happens behind the shutter, in the order of a camera: blur, vignetting, shot noise
/// and white balance in linear light, Gaussian noise on the encoded values (as SDF's camera noise),
/// then JPEG compression.
/// @param picture  CV_8UC3, sRGB-encoded; returned as it is if there is nothing to do
/// @param seed  of the noise: the same seed gives the same picture
[[nodiscard]] cv::Mat applyEffects(const cv::Mat& picture, const SensorEffects& effects,
                                   std::uint64_t seed);

}  // namespace synthetic_dataset::render

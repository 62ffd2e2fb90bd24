#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

/// What lens and sensor do to a picture. Plain pictures in, plain pictures out.
namespace synthetic_dataset::sensor {

/// Nothing by default.
struct SensorEffects {
  double exposure = 0.0;    ///< [stops]; the renderer applies it, before it limits what is bright
  double blur = 0.0;        ///< standard deviation of the point spread [px]
  double vignetting = 0.0;  ///< 0 .. 1: the share of light that the image's corners lack
  double full_well = 0.0;  ///< electrons of a white pixel, whose number is random; 0: no shot noise
  double noise_mean = 0.0;    ///< of a Gaussian added to the values of pixels, of the full scale
  double noise_stddev = 0.0;  ///< of a Gaussian added to the values of pixels, of the full scale
};

/// The factor on all light that is the effects' exposure.
[[nodiscard]] double gainOf(const SensorEffects& effects);

/// Applies what happens behind the shutter, in the order of a camera: blur, vignetting and shot
/// noise in linear light, then Gaussian noise on the encoded values (as SDF's camera noise).
/// @param picture  CV_8UC3, sRGB-encoded; given back as it is where there is nothing to do
/// @param seed  of the noise: the same seed gives the same picture
[[nodiscard]] cv::Mat applyEffects(const cv::Mat& picture, const SensorEffects& effects,
                                   std::uint64_t seed);

}  // namespace synthetic_dataset::sensor

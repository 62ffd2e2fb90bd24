#pragma once

namespace synthetic_dataset::render {

/// What lens and sensor do to a picture; nothing by default.
struct SensorEffects {
  double exposure = 0.0;    ///< [stops]; the renderer applies it, before it limits what is bright
  double blur = 0.0;        ///< standard deviation of the point spread [px]
  double vignetting = 0.0;  ///< 0 .. 1: the share of light that the image's corners lack
  double full_well = 0.0;  ///< electrons of a white pixel, whose number is random; 0: no shot noise
  double noise_mean = 0.0;    ///< of a Gaussian added to the values of pixels, of the full scale
  double noise_stddev = 0.0;  ///< of a Gaussian added to the values of pixels, of the full scale
};

}  // namespace synthetic_dataset::render

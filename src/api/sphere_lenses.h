#pragma once

#include "api/lens_model.h"

/// Lenses that see the world on a unit sphere and project that.
namespace synthetic_dataset::lens {

/// Mei and Rives 2007, as cv::omnidir and Kalibr (`omni` with `radtan`) have it: the sphere is seen
/// from xi behind its middle, and the picture is then bent by k1, k2, p1, p2. The last coefficient
/// is cv::omnidir's skew, divided by fx.
extern const LensFunctions kOmnidirectionalLens;

/// Usenko, Demmel and Cremers 2018, as Kalibr (`ds`) and basalt have it: two spheres, xi apart, the
/// second of which is seen from alpha / (1 - alpha) behind its middle.
extern const LensFunctions kDoubleSphereLens;

[[nodiscard]] std::string omnidirectionalFault(const Distortion& distortion);
[[nodiscard]] std::string doubleSphereFault(const Distortion& distortion);

}  // namespace synthetic_dataset::lens

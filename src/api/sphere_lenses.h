#pragma once

#include "api/lens_model.h"

/// Lenses that project the world to a unit sphere and then project the sphere.
namespace synthetic_dataset::lens {

/// Mei and Rives 2007, as in cv::omnidir and Kalibr (`omni` with `radtan`): the sphere is seen from
/// xi behind its centre, and the picture is then distorted by k1, k2, p1, p2. The last coefficient
/// is cv::omnidir's skew, divided by fx.
extern const LensFunctions kOmnidirectionalLens;

/// Usenko, Demmel and Cremers 2018, as in Kalibr (`ds`) and basalt: two spheres, xi apart, the
/// second of which is seen from alpha / (1 - alpha) behind its centre.
extern const LensFunctions kDoubleSphereLens;

[[nodiscard]] std::string omnidirectionalFault(const Distortion& distortion);
[[nodiscard]] std::string doubleSphereFault(const Distortion& distortion);

}  // namespace synthetic_dataset::lens

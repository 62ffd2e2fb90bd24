#pragma once

#include "render/pixels/lanes.h"

/// How surfaces with GGX highlights reflect their surroundings: the second part of the "split sum"
/// (Karis 2013, "Real Shading in Unreal Engine 4"), of which PanoramaLight is the first.

namespace synthetic_dataset::render {

/// The share of uniformly white surroundings that a surface reflects specularly: the integral of
/// the highlight of SurfaceShading, interpolated in a table. (Fits such as that of Karis 2014,
/// "Physically Based Shading on Mobile", are shorter but make metals up to a sixth darker.)
/// @param f0  the reflectance at normal incidence
[[nodiscard]] Lanes3 mirroredShare(const Lanes3& f0, const Lanes& roughness, const Lanes& n_dot_v);

/// The direction from which, approximately, most of the reflected light comes: for a rough surface,
/// it is closer to the normal than the mirror direction (Lagarde and de Rousiers 2014, "Moving
/// Frostbite to Physically Based Rendering", listing 22).
[[nodiscard]] Lanes3 mirroredDirection(const Lanes3& normal, const Lanes3& to_eye,
                                       const Lanes& roughness);

/// The share of the reflection that nearby surfaces do not occlude (same source, listing 26).
/// @param open  the share of the ambient light that they do not occlude
[[nodiscard]] Lanes mirroredOpenness(const Lanes& open, const Lanes& roughness,
                                     const Lanes& n_dot_v);

}  // namespace synthetic_dataset::render

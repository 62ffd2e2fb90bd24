#pragma once

#include "render/pixels/lanes.h"

/// How surfaces with GGX highlights mirror what is all around them: the second part of the "split
/// sum" (Karis 2013, "Real Shading in Unreal Engine 4"), of which PanoramaLight has the first.

namespace synthetic_dataset::render {

/// The share of an evenly white surrounding that a surface mirrors: the integral over the highlight
/// that SurfaceShading makes of a light, between the points of a table. (Fits such as that of Karis
/// 2014, "Physically Based Shading on Mobile", are shorter and make metals up to a sixth darker.)
/// @param f0  what it mirrors head-on
[[nodiscard]] Lanes3 mirroredShare(const Lanes3& f0, const Lanes& roughness, const Lanes& n_dot_v);

/// About which direction most of what is mirrored comes from: with a rough surface, nearer to its
/// normal than a mirror would have it (Lagarde and de Rousiers 2014, "Moving Frostbite to
/// Physically Based Rendering", listing 22).
[[nodiscard]] Lanes3 mirroredDirection(const Lanes3& normal, const Lanes3& to_eye,
                                       const Lanes& roughness);

/// The share of what is mirrored that other things near the surface leave (the same, listing 26).
/// @param open  the share of the light from everywhere that they leave
[[nodiscard]] Lanes mirroredOpenness(const Lanes& open, const Lanes& roughness,
                                     const Lanes& n_dot_v);

}  // namespace synthetic_dataset::render

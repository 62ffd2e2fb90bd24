#pragma once

namespace synthetic_dataset::render {

/// The aperture of all lenses, which makes near things out of focus [m].
inline constexpr double kLensAperture = 2e-3;

}  // namespace synthetic_dataset::render

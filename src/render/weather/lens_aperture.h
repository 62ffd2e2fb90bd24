#pragma once

namespace synthetic_dataset::render {

/// Of all lenses, through which what is near is out of focus [m].
inline constexpr double kLensAperture = 2e-3;

}  // namespace synthetic_dataset::render

#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/canvas.h"

/// Simulates a camera.
namespace synthetic_dataset::randomize::natural {

/// Puts everything drawn so far out of focus.
/// @param radius  [px]
void soften(Canvas& canvas, int radius);

/// Applies the light's colour, exposure and contrast; the lens's point spread and vignetting; the
/// sensor's grain.
void develop(Canvas& canvas, base::RandomSource& random);

}  // namespace synthetic_dataset::randomize::natural

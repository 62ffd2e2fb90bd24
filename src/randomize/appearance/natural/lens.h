#pragma once

#include "base/random/random_source.h"
#include "randomize/appearance/natural/canvas.h"

/// What a camera makes of what is before it.
namespace synthetic_dataset::randomize::natural {

/// Puts what is drawn so far out of focus.
/// @param radius  [px]
void soften(Canvas& canvas, int radius);

/// The light's colour, exposure and contrast; the lens' point spread, its darker corners; the
/// sensor's grain.
void develop(Canvas& canvas, base::RandomSource& random);

}  // namespace synthetic_dataset::randomize::natural

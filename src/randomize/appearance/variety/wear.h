#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "randomize/appearance/variety/paint_palette.h"
#include "randomize/appearance/variety/solid_noise.h"

namespace synthetic_dataset::randomize {

/// The effects of age on a surface: it fades, becomes dirty from below, is scuffed, and rain leaves
/// streaks. Amounts are from 0 to 1.
struct Wear {
  float fading = 0.0F;
  float dirt = 0.0F;
  Eigen::Vector3f dirt_colour{0.3F, 0.27F, 0.23F};
  float splashes = 0.0F;  ///< how much dirtier it is near the ground
  float scuffs = 0.0F;
  float scuff_lightness = 0.7F;
  float streaks = 0.0F;
  int scratches = 0;
  Eigen::Vector3f offset{0.0F, 0.0F, 0.0F};  ///< into the noise that decides where

  [[nodiscard]] bool isClean() const {
    return fading + dirt + scuffs + streaks <= 0.0F && scratches == 0;
  }

  /// @param colour  sRGB-encoded
  /// @param place  in the model, in units of its largest side
  /// @param height  0 at the model's foot .. 1 at its top
  void apply(Eigen::Vector3f& colour, const Eigen::Vector3f& place, float height,
             const SolidNoise& noise) const;
};

/// @param strength  how worn it may be, 0 .. 1; little wear is the most likely
[[nodiscard]] Wear drawWear(base::RandomSource& random, double strength);

}  // namespace synthetic_dataset::randomize

#pragma once

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::world {

/// The roughness (0 mirror .. 1 chalk) of a Blinn-Phong highlight with the given exponent.
/// The exponent n and the width alpha of a microfacet distribution have highlights of the same
/// width where n = 2 / alpha^2 - 2 (Walter et al., "Microfacet models for refraction through rough
/// surfaces", 2007, section 5.2), and alpha is the square of what artists and glTF call roughness.
/// @param exponent  0 or more; Phong's and Blinn's are not distinguished
[[nodiscard]] inline float roughnessOfShininess(float exponent) {
  const float n = std::isfinite(exponent) ? std::max(exponent, 0.0F) : 0.0F;
  return std::sqrt(std::sqrt(2.0F / (n + 2.0F)));
}

/// The other way round: the exponent of the highlight of a surface that is so rough.
/// @param roughness  0 mirror .. 1 chalk, which has none: 0
[[nodiscard]] inline float shininessOfRoughness(float roughness) {
  constexpr float kSharpest = 1000.0F;
  const float alpha = std::max(roughness * roughness, 1e-3F);
  return std::min(2.0F / (alpha * alpha) - 2.0F, kSharpest);
}

}  // namespace synthetic_dataset::world

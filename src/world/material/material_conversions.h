#pragma once

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::world {

/// Encodes a linear colour component as sRGB (IEC 61966-2-1).
/// @param linear  0 to 1; values outside are clamped
[[nodiscard]] inline float encodedComponent(float linear) {
  const float x = std::clamp(linear, 0.0F, 1.0F);
  return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1.0F / 2.4F) - 0.055F;
}

/// Decodes an sRGB-encoded component, 0 to 1, to a linear one; values outside are clamped.
[[nodiscard]] inline float linearComponent(float encoded) {
  const float x = std::clamp(encoded, 0.0F, 1.0F);
  return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
}

/// The roughness (0 mirror .. 1 chalk) of a Blinn-Phong highlight with the given exponent. The
/// exponent n and the width alpha of a microfacet distribution have highlights of the same width if
/// n = 2 / alpha^2 - 2 (Walter et al., "Microfacet models for refraction through rough surfaces",
/// 2007, section 5.2), and alpha is the square of what artists and glTF call roughness.
/// @param exponent  0 or more; Phong's and Blinn's are not distinguished
[[nodiscard]] inline float roughnessOfShininess(float exponent) {
  const float n = std::isfinite(exponent) ? std::max(exponent, 0.0F) : 0.0F;
  return std::sqrt(std::sqrt(2.0F / (n + 2.0F)));
}

/// The inverse: the exponent of the highlight of a surface with the given roughness.
/// @param roughness  0 mirror .. 1 chalk, which has no highlight: 0
[[nodiscard]] inline float shininessOfRoughness(float roughness) {
  constexpr float kSharpest = 1000.0F;
  const float alpha = std::max(roughness * roughness, 1e-3F);
  return std::min(2.0F / (alpha * alpha) - 2.0F, kSharpest);
}

}  // namespace synthetic_dataset::world

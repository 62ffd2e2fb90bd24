#pragma once

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::world {

/// A linear colour component in sRGB's encoding (IEC 61966-2-1).
/// @param linear  0 to 1; what is beyond is clamped
[[nodiscard]] inline float encodedComponent(float linear) {
  const float x = std::clamp(linear, 0.0F, 1.0F);
  return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1.0F / 2.4F) - 0.055F;
}

/// The linear component of an sRGB-encoded one, 0 to 1; what is beyond is clamped.
[[nodiscard]] inline float linearComponent(float encoded) {
  const float x = std::clamp(encoded, 0.0F, 1.0F);
  return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
}

}  // namespace synthetic_dataset::world

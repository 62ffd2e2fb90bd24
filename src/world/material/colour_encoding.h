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

}  // namespace synthetic_dataset::world

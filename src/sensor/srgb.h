#pragma once

#include <array>
#include <cstdint>

namespace synthetic_dataset::sensor {

/// The light of each sRGB-encoded value (IEC 61966-2-1), 0 .. 1.
[[nodiscard]] const std::array<float, 256>& linearFromSrgb();

/// The nearest sRGB-encoded value of a light; beyond 0 .. 1 it is clipped.
[[nodiscard]] std::uint8_t srgbFromLinear(float linear);

}  // namespace synthetic_dataset::sensor

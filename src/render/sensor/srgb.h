#pragma once

#include <array>
#include <cstdint>

namespace synthetic_dataset::render {

/// sRGB's transfer function (IEC 61966-2-1): the light of an encoded value, both 0 .. 1.
[[nodiscard]] float linearFromSrgb(float encoded);

/// The light of each encoded value of 8 bits.
[[nodiscard]] const std::array<float, 256>& linearFromSrgb();

/// The nearest sRGB-encoded value of a light; beyond 0 .. 1 it is clipped.
[[nodiscard]] std::uint8_t srgbFromLinear(float linear);

}  // namespace synthetic_dataset::render

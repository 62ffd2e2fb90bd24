#pragma once

#include <cstdint>
#include <cstring>

namespace synthetic_dataset::render {

/// A number of 16 bits (IEEE 754 binary16), as OpenGL gives it; neither infinite nor NaN. In steps
/// that compilers can do for many at a time.
[[nodiscard]] inline float fromHalf(std::uint16_t bits) {
  // Exponent and fraction moved to their places in 32 bits; the factor makes up for the exponents'
  // biases, 15 and 127, also of subnormal numbers.
  const std::uint32_t magnitude = (bits & 0x7FFFU) << 13U;
  float number = 0.0F;
  std::memcpy(&number, &magnitude, sizeof number);
  number *= 0x1p112F;
  return (bits & 0x8000U) != 0 ? -number : number;
}

}  // namespace synthetic_dataset::render

#pragma once

#include <cstdint>
#include <cstring>

namespace synthetic_dataset::render {

/// Converts a half float (IEEE 754 binary16), as returned by OpenGL; it must be neither infinite
/// nor NaN. The steps are such that compilers can vectorize them.
[[nodiscard]] inline float fromHalf(std::uint16_t bits) {
  // Moves exponent and fraction to their places in 32 bits; the factor compensates for the
  // exponents' biases, 15 and 127, also for subnormal numbers.
  const std::uint32_t magnitude = (bits & 0x7FFFU) << 13U;
  float number = 0.0F;
  std::memcpy(&number, &magnitude, sizeof number);
  number *= 0x1p112F;
  return (bits & 0x8000U) != 0 ? -number : number;
}

}  // namespace synthetic_dataset::render

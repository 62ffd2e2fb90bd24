#pragma once

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

/// A colour by hue (0 red, 1/3 green, 2/3 blue, repeats after 1), saturation and value, 0 to 1.
struct HueColour {
  float hue = 0.0F;
  float saturation = 0.0F;
  float value = 0.0F;
};

/// @param colour  red, green, blue, 0 to 1
[[nodiscard]] HueColour toHue(const Eigen::Vector3f& colour);

/// @param colour  saturation and value are clamped to 0 .. 1
[[nodiscard]] Eigen::Vector3f toRgb(const HueColour& colour);

}  // namespace synthetic_dataset::randomize

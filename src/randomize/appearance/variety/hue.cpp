#include "randomize/appearance/variety/hue.h"

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::randomize {

HueColour toHue(const Eigen::Vector3f& colour) {
  Eigen::Index strongest = 0;
  const float high = colour.maxCoeff(&strongest);
  const float range = high - colour.minCoeff();
  if (high <= 0.0F || range <= 0.0F) return {0.0F, 0.0F, std::max(high, 0.0F)};
  const auto next = (strongest + 1) % 3;
  const float sector = (colour[next] - colour[(strongest + 2) % 3]) / range;
  const float hue = (2.0F * static_cast<float>(strongest) + sector) / 6.0F;
  return {hue - std::floor(hue), range / high, high};
}

Eigen::Vector3f toRgb(const HueColour& colour) {
  const float saturation = std::clamp(colour.saturation, 0.0F, 1.0F);
  const float value = std::clamp(colour.value, 0.0F, 1.0F);
  Eigen::Vector3f result;
  for (int i = 0; i < 3; ++i) {
    const float off = colour.hue - static_cast<float>(i) / 3.0F + 0.5F;
    const float distance = std::abs(off - std::floor(off) - 0.5F);  // from the channel's own hue
    const float amount = std::clamp(2.0F - 6.0F * distance, 0.0F, 1.0F);
    result[i] = value * (1.0F - saturation * (1.0F - amount));
  }
  return result;
}

}  // namespace synthetic_dataset::randomize

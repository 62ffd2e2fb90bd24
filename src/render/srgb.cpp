#include "render/srgb.h"

#include <cmath>

namespace synthetic_dataset::render {

float linearFromSrgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded) {
  return encoded.unaryExpr([](float channel) { return linearFromSrgb(channel); });
}

Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded) {
  Eigen::Vector4f linear;
  linear << linearFromSrgb(Eigen::Vector3f(encoded.head<3>())), encoded.w();
  return linear;
}

}  // namespace synthetic_dataset::render

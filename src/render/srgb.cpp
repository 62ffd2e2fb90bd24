#include "render/srgb.h"

#include "sensor/srgb.h"

namespace synthetic_dataset::render {

Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded) {
  return encoded.unaryExpr([](float channel) { return sensor::linearFromSrgb(channel); });
}

Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded) {
  Eigen::Vector4f linear;
  linear << linearFromSrgb(Eigen::Vector3f(encoded.head<3>())), encoded.w();
  return linear;
}

}  // namespace synthetic_dataset::render

#pragma once

#include <Eigen/Core>

namespace synthetic_dataset::render {

/// Linear light from sRGB-encoded red, green and blue.
[[nodiscard]] Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded);

/// Alpha, the last, is linear in either.
[[nodiscard]] Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded);

}  // namespace synthetic_dataset::render

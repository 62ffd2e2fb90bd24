#pragma once

#include <Eigen/Core>

namespace synthetic_dataset::render {

/// sRGB's transfer function (IEC 61966-2-1): linear light from an encoded channel.
[[nodiscard]] float linearFromSrgb(float encoded);

[[nodiscard]] Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded);

/// Alpha, the last, is linear in either.
[[nodiscard]] Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded);

}  // namespace synthetic_dataset::render

#pragma once

#include <array>

#include <Eigen/Core>

namespace synthetic_dataset {
inline namespace v2 {

/// A box aligned with the axes of some frame [m].
struct Cuboid {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();   ///< the corner with the least x, y and z
  Eigen::Vector3d high = Eigen::Vector3d::Zero();  ///< the corner with the greatest x, y and z

  [[nodiscard]] Eigen::Vector3d centre() const { return 0.5 * (low + high); }
  [[nodiscard]] Eigen::Vector3d size() const { return high - low; }

  /// Corner i has the high x if i & 4, the high y if i & 2 and the high z if i & 1:
  /// (---, --+, -+-, -++, +--, +-+, ++-, +++).
  [[nodiscard]] std::array<Eigen::Vector3d, 8> corners() const {
    std::array<Eigen::Vector3d, 8> result;
    for (unsigned i = 0; i < 8; ++i) {
      result[i] = {(i & 4U) != 0 ? high.x() : low.x(), (i & 2U) != 0 ? high.y() : low.y(),
                   (i & 1U) != 0 ? high.z() : low.z()};
    }
    return result;
  }
};

}  // namespace v2
}  // namespace synthetic_dataset

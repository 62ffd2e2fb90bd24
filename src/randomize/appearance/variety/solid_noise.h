#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

/// Cloudy noise that fills space and repeats after one unit along each axis. Values are uniform
/// from 0 to 1, so that a given share of all places lies above 1 - share.
class SolidNoise {
 public:
  /// The noise used to wear all models; it looks different at different places.
  [[nodiscard]] static const SolidNoise& shared();

  /// @param place  within 60 units of the origin
  [[nodiscard]] float at(const Eigen::Vector3f& place) const;

 private:
  static constexpr int kSide = 64;  ///< samples along each axis; a power of two

  SolidNoise();

  std::vector<std::uint8_t> samples_;  ///< x fastest
};

}  // namespace synthetic_dataset::randomize

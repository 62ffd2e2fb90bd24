#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

/// Cloudy noise that fills space and repeats after one unit along each axis. Each value from 0 to 1
/// is as likely as the others, so a share of all places lies above 1 - share.
class SolidNoise {
 public:
  /// The one that all models are worn by; at other places, it looks unlike itself.
  [[nodiscard]] static const SolidNoise& shared();

  /// @param place  within 60 units of the origin
  [[nodiscard]] float at(const Eigen::Vector3f& place) const;

 private:
  static constexpr int kSide = 64;  ///< samples along each axis; a power of two

  SolidNoise();

  std::vector<std::uint8_t> samples_;  ///< x fastest
};

}  // namespace synthetic_dataset::randomize

#pragma once

#include <cstddef>
#include <optional>

#include "base/random/random_source.h"
#include "randomize/placement/placement_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::randomize {

/// Objects in a row, as cones, chairs and parked cars stand: nearly straight, at nearly equal
/// distances, turned nearly alike.
class ObjectRow {
 public:
  /// @param widest  of the objects, as seen from above [m]
  /// @param count  of objects
  ObjectRow(const Volume& volume, double widest, std::size_t count, base::RandomSource& source);

  /// X_GO of an upright object.
  /// @param number  of its place in the row, below the count
  /// @return nothing where that is outside of the volume
  [[nodiscard]] std::optional<Pose> place(std::size_t number, base::RandomSource& source) const;

 private:
  Volume volume_;
  Eigen::Vector3d first_G_;
  Eigen::Vector3d step_G_;
  double heading_;  ///< of the objects [rad]
};

}  // namespace synthetic_dataset::randomize

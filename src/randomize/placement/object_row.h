#pragma once

#include <cstddef>
#include <optional>

#include "base/random/random_source.h"
#include "randomize/placement/placement_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::randomize {

/// Objects in a row, like cones, chairs and parked cars: nearly straight, at nearly equal
/// distances, and turned nearly alike.
class ObjectRow {
 public:
  /// @param widest  width of the widest object, as seen from above [m]
  /// @param count  number of objects
  ObjectRow(const Volume& volume, double widest, std::size_t count, base::RandomSource& source);

  /// X_GO of an upright object.
  /// @param number  index of its place in the row, less than the count
  /// @return nothing if the place is outside the volume
  [[nodiscard]] std::optional<Pose> place(std::size_t number, base::RandomSource& source) const;

 private:
  Volume volume_;
  Eigen::Vector3d first_G_;
  Eigen::Vector3d step_G_;
  double heading_;  ///< of the objects [rad]
};

}  // namespace synthetic_dataset::randomize

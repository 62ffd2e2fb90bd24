#pragma once

#include <map>
#include <string>
#include <variant>

#include <Eigen/Core>

#include "randomize/placement/placement_options.h"
#include "randomize/placement/surroundings.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::randomize {

/// Why places were rejected, and how often: "612 were inside 'shelf', 3 were too near 'alpha'"; the
/// most frequent reasons first.
[[nodiscard]] std::string reasonsText(const std::map<std::string, int>& misses);

/// A pose, or why there is none.
using PoseOrReason = std::variant<Pose, std::string>;

/// Finds poses in which things stand on what is there: floors, tables, ramps.
class StandingPlace {
 public:
  /// @param surroundings  must outlive this
  StandingPlace(Surroundings& surroundings, const SurfaceOptions& options)
      : surroundings_(surroundings), options_(options) {}

  /// X_GO with which a thing stands on the highest surface at a place, its z axis along the
  /// surface's normal.
  /// @param place_G  of the thing's frame, as seen from above [m]
  /// @param heading  about the normal [rad]
  /// @param box_O  around the thing, which stands on the bottom of it
  [[nodiscard]] PoseOrReason at(const Eigen::Vector2d& place_G, double heading,
                                const Cuboid& box_O) const;

 private:
  [[nodiscard]] bool liesEven(const Pose& X_GO, const Cuboid& box_O) const;

  Surroundings& surroundings_;
  SurfaceOptions options_;
};

}  // namespace synthetic_dataset::randomize

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/random/random_source.h"
#include "randomize/placement/placement_options.h"
#include "randomize/placement/surroundings.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::randomize {

/// Something that a camera may look at.
struct CameraTarget {
  std::string name;
  Eigen::Vector3d centre_G{0, 0, 0};
  bool is_present = true;  ///< what is not is looked at only by its name, or where nothing is
  double size = 0.0;       ///< the diagonal of its cuboid [m]
};

/// Where a camera was put.
struct SampledPose {
  Pose X_GC;  ///< of the optical frame

  /// Why none of the positions that were tried sees what the camera looks at, as of an object that
  /// is inside of a wall; empty: this one does.
  std::string hidden;
};

/// Puts a camera somewhere at random, scene by scene, looking at objects; never inside anything,
/// and where no wall hides what it looks at, if there is such a position.
class CameraSampler {
 public:
  /// @param group  the camera's parameters, for messages: "camera"
  /// @param world  has to outlive this, and so have its surroundings
  CameraSampler(CameraSampling config, std::string group, const world::World& world,
                Surroundings& surroundings, std::uint64_t seed);

  /// As the world stands now: a function of the seed, the scene and the camera's name alone.
  /// @param targets  the objects, where they stand
  /// @throws Error where no free position was found, and why
  [[nodiscard]] SampledPose sample(std::int64_t scene,
                                   const std::vector<CameraTarget>& targets) const;

 private:
  /// What the camera is to look at, and where from.
  struct Look {
    Eigen::Vector3d target_G;
    Eigen::Vector3d aim_G;  ///< the target, but for the offset
    Eigen::Vector3d position_G;
    Pose X_GC;
  };

  [[nodiscard]] Look draw(base::RandomSource& source,
                          const std::vector<CameraTarget>& targets) const;
  [[nodiscard]] std::optional<std::string> whyNotFree(const Look& look) const;
  [[nodiscard]] bool seesTarget(const Look& look) const;
  [[nodiscard]] CameraTarget target(base::RandomSource& source,
                                    const std::vector<CameraTarget>& targets) const;
  [[nodiscard]] Eigen::Vector3d position(base::RandomSource& source,
                                         const CameraTarget& target) const;

  CameraSampling config_;
  std::string group_;
  const world::World& world_;
  Surroundings& surroundings_;
  std::uint64_t seed_;
};

/// X_GC of an optical frame at a place that looks at another, the image's up along the vertical but
/// for a roll about the line of sight [rad], clockwise as the picture's viewer sees the camera
/// turn.
[[nodiscard]] Pose lookingAt(const Eigen::Vector3d& position_G, const Eigen::Vector3d& aim_G,
                             double roll);

}  // namespace synthetic_dataset::randomize

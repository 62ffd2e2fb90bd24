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
  bool is_present = true;  ///< absent ones are only looked at by name, or if none is present
  double size = 0.0;       ///< the diagonal of its cuboid [m]
};

/// The pose chosen for a camera.
struct SampledPose {
  Pose X_GC;  ///< of the optical frame

  /// Why none of the positions tried sees the target, for example because it is inside a wall;
  /// empty if this position does.
  std::string hidden;
};

/// Places a camera at random in each scene, looking at objects: never inside anything, and where no
/// wall hides the target if there is such a position.
class CameraSampler {
 public:
  /// @param group  the camera's parameters, for messages: "camera"
  /// @param world  must outlive this, and so must its surroundings
  CameraSampler(CameraSampling config, std::string group, const world::World& world,
                Surroundings& surroundings, std::uint64_t seed);

  /// Samples a pose for the current state of the world; apart from that, depends only on the seed,
  /// the scene and the camera's name.
  /// @param targets  the objects, where they are now
  /// @throws Error if no free position was found, saying why
  [[nodiscard]] SampledPose sample(std::int64_t scene,
                                   const std::vector<CameraTarget>& targets) const;

 private:
  /// A target for the camera, and a position to view it from.
  struct Look {
    Eigen::Vector3d target_G;
    Eigen::Vector3d aim_G;  ///< the target plus the offset
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

/// X_GC of an optical frame at one place looking at another. The image's up is along the vertical,
/// except for a roll about the line of sight [rad], clockwise as a viewer of the picture sees the
/// camera turn.
[[nodiscard]] Pose lookingAt(const Eigen::Vector3d& position_G, const Eigen::Vector3d& aim_G,
                             double roll);

}  // namespace synthetic_dataset::randomize

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "lidar/ray_bodies.h"
#include "render/render_options.h"
#include "world/world.h"

namespace synthetic_dataset::lidar {

/// A link that moves, and a ball around it.
struct MovingBody {
  std::size_t link = 0;  ///< of the world's links
  std::size_t body = 0;  ///< among the RayBodies
  Eigen::Vector3d centre_L{0, 0, 0};
  double radius = 0.0;  ///< [m]
};

/// What rays can meet of a world: its visuals, as pictures show them. What stands still is one
/// body, each link that may move is one of its own. Glass is left out where labels leave it out.
class ScannedWorld {
 public:
  /// @param world  before anything has moved; has to outlive this
  /// @param glass  which surfaces that one can see through are met
  ScannedWorld(const world::World& world, render::GlassInLabels glass);

  [[nodiscard]] const RayBodies& bodies() const { return bodies_; }

  /// The body of all that stands still, if there is anything, and where its frame lies: its axes
  /// are those of the world.
  [[nodiscard]] const std::optional<std::size_t>& standing() const { return standing_; }
  [[nodiscard]] const Eigen::Vector3d& standingOrigin() const { return origin_W_; }

  [[nodiscard]] const std::vector<MovingBody>& moving() const { return moving_; }

  [[nodiscard]] world::Simulator simulator() const { return simulator_; }

  /// The materials of all surfaces.
  /// @param varied  by those that they were made with (world::Look::materials); has to outlive it
  [[nodiscard]] Paint paint(const std::map<const world::Material*, world::Material>& varied) const;

 private:
  RayBodies bodies_;
  std::optional<std::size_t> standing_;
  Eigen::Vector3d origin_W_{0, 0, 0};
  std::vector<MovingBody> moving_;
  world::Simulator simulator_;
};

}  // namespace synthetic_dataset::lidar

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

/// A link that moves, and a bounding sphere around it.
struct MovingBody {
  std::size_t link = 0;  ///< index in the world's links
  std::size_t body = 0;  ///< index in the RayBodies
  Eigen::Vector3d centre_L{0, 0, 0};
  double radius = 0.0;  ///< [m]
};

/// The parts of a world that rays can hit: its visuals, as pictures show them. Everything that
/// stands still is one body; each link that may move is a body of its own. Glass is left out if
/// labels leave it out.
class ScannedWorld {
 public:
  /// @param world  before anything has moved; has to outlive this
  /// @param glass  which transparent surfaces are hit
  ScannedWorld(const world::World& world, render::GlassInLabels glass);

  [[nodiscard]] const RayBodies& bodies() const { return bodies_; }

  /// The body of everything that stands still, if there is any, and the origin of its frame, whose
  /// axes are those of the world.
  [[nodiscard]] const std::optional<std::size_t>& standing() const { return standing_; }
  [[nodiscard]] const Eigen::Vector3d& standingOrigin() const { return origin_W_; }

  [[nodiscard]] const std::vector<MovingBody>& moving() const { return moving_; }

  [[nodiscard]] world::Simulator simulator() const { return simulator_; }

  /// The current materials of all surfaces.
  /// @param varied  the varied materials, by those in the models (world::Look::materials); has to
  ///     outlive the result
  [[nodiscard]] Paint paint(const std::map<const world::Material*, world::Material>& varied) const;

 private:
  RayBodies bodies_;
  std::optional<std::size_t> standing_;
  Eigen::Vector3d origin_W_{0, 0, 0};
  std::vector<MovingBody> moving_;
  world::Simulator simulator_;
};

}  // namespace synthetic_dataset::lidar

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/description.h"

namespace synthetic_dataset::lidar {

/// The version of the library that casts rays, such as "3.13.5".
[[nodiscard]] std::string rayCasterVersion();

/// A mesh with one material that rays can hit.
struct RaySurface {
  std::shared_ptr<const world::Mesh> mesh;
  const world::Material* material = nullptr;  ///< as in the model
  std::size_t link = 0;                       ///< index in the world's links
  Pose X_BV = Pose::Identity();               ///< of the mesh in its body
  bool has_holes = false;                     ///< at texels whose alpha is small
};

/// The materials of the surfaces at a given time, by surface index.
using Paint = std::vector<const world::Material*>;

/// The first hit of a ray on a surface.
struct RayHit {
  std::size_t surface = 0;   ///< its index, in the order of adding
  std::size_t triangle = 0;  ///< index in its mesh
  double distance = 0.0;     ///< along the ray [m]
  double b1 = 0.0;           ///< the weight of the triangle's second corner,
  double b2 = 0.0;           ///< of its third one; the first has the rest
};

/// Rigid bodies of triangles, and ray casts against them (Embree; Wald et al. 2014, "Embree: A
/// Kernel Framework for Efficient CPU Ray Tracing"). Nothing has to be rebuilt when a body moves,
/// as rays are given in the body's frame. Surfaces are hit only from the side of their normals,
/// unless they are double-sided, as the renderer draws them.
///
/// Which triangle is hit is found in single precision and watertight; its distance is computed in
/// double precision, so that ranges do not depend on the processor's approximations.
class RayBodies {
 public:
  RayBodies();
  ~RayBodies();
  RayBodies(const RayBodies&) = delete;
  RayBodies& operator=(const RayBodies&) = delete;

  /// @return the body's index
  std::size_t add(std::vector<RaySurface> surfaces);

  /// The surfaces of all bodies.
  [[nodiscard]] const std::vector<RaySurface>& surfaces() const;

  /// Casts a ray against a body. May be called in any thread, as long as nothing is being added.
  /// @param direction_B  of length 1
  /// @param near, far  [m]
  [[nodiscard]] std::optional<RayHit> meet(std::size_t body, const Eigen::Vector3d& origin_B,
                                           const Eigen::Vector3d& direction_B, double near,
                                           double far, const Paint& paint) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::lidar

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

/// The version of the library that casts rays: "3.13.5".
[[nodiscard]] std::string rayCasterVersion();

/// A mesh in one material that rays can meet.
struct RaySurface {
  std::shared_ptr<const world::Mesh> mesh;
  const world::Material* material = nullptr;  ///< that it was made with
  std::size_t link = 0;                       ///< of the world's links
  Pose X_BV = Pose::Identity();               ///< of the mesh in its body
  bool has_holes = false;                     ///< where its texture's alpha is small
};

/// The materials that surfaces have at a time, by their indices.
using Paint = std::vector<const world::Material*>;

/// Where a ray meets a surface first.
struct RayHit {
  std::size_t surface = 0;   ///< its index, in the order in which they were added
  std::size_t triangle = 0;  ///< of its mesh
  double distance = 0.0;     ///< along the ray [m]
  double b1 = 0.0;           ///< the weight of the triangle's second corner,
  double b2 = 0.0;           ///< of its third one; the first has the rest
};

/// Bodies of triangles, each rigid, and rays that meet them (Embree; Wald et al. 2014, "Embree: A
/// Kernel Framework for Efficient CPU Ray Tracing"). Nothing has to be made anew when a body moves:
/// rays come in its own frame. Surfaces are met from the side of their normals alone, unless they
/// are double-sided, as the renderer draws them.
///
/// Which triangle is met is found in single precision and watertight; how far away, in double, so
/// that ranges do not depend on the processor's approximations.
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

  /// In any thread, as long as nothing is added.
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

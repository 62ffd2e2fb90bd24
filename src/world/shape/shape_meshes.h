#pragma once

/// Geometric shapes as triangles, with normals and texture coordinates. Curved ones are tessellated
/// so finely that no point of the mesh lies deeper than 0.2 % of the radius below the true surface.

#include <memory>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

/// @param size  full lengths along x, y, z [m]; each face shows the whole texture, oriented as in
///     Gazebo: upright on the sides; on top, x is up and -y to the right
[[nodiscard]] std::shared_ptr<const Mesh> boxMesh(const Eigen::Vector3d& size);

/// The texture is wrapped around the y axis (aroundY).
[[nodiscard]] std::shared_ptr<const Mesh> sphereMesh(double radius);

/// @param radii  along x, y, z [m]
[[nodiscard]] std::shared_ptr<const Mesh> ellipsoidMesh(const Eigen::Vector3d& radii);

/// A cylinder along z, centred at the origin, with both caps. The texture is wrapped around it
/// (aroundCylinder).
[[nodiscard]] std::shared_ptr<const Mesh> cylinderMesh(double radius, double length);

/// A cylinder along z with hemispheres as caps. @param length  of the cylinder only [m]
[[nodiscard]] std::shared_ptr<const Mesh> capsuleMesh(double radius, double length);

/// A rectangle centred at the origin, visible from the side to which its normal points. With the
/// normal along z, `size` is along x and y; for other normals, this plane is turned by the shortest
/// rotation.
[[nodiscard]] std::shared_ptr<const Mesh> planeMesh(const Eigen::Vector3d& normal,
                                                    const Eigen::Vector2d& size);

}  // namespace synthetic_dataset::world

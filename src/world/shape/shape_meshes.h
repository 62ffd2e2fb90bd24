#pragma once

/// Geometric shapes as triangles, with normals and texture coordinates. Curved ones are fine enough
/// that no point of the mesh lies deeper than 0.2 % of the radius below the true surface.

#include <memory>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

/// @param size  whole lengths along x, y, z [m]; each face shows the whole texture, as
///     Gazebo turns it: upright on the sides; above, x is up and -y to the right
[[nodiscard]] std::shared_ptr<const Mesh> boxMesh(const Eigen::Vector3d& size);

/// The texture is wrapped around the y axis (aroundY).
[[nodiscard]] std::shared_ptr<const Mesh> sphereMesh(double radius);

/// @param radii  along x, y, z [m]
[[nodiscard]] std::shared_ptr<const Mesh> ellipsoidMesh(const Eigen::Vector3d& radii);

/// About z, centred, with both caps. The texture is wrapped around it (aroundCylinder).
[[nodiscard]] std::shared_ptr<const Mesh> cylinderMesh(double radius, double length);

/// A cylinder about z with half spheres as caps. @param length  of the cylinder alone [m]
[[nodiscard]] std::shared_ptr<const Mesh> capsuleMesh(double radius, double length);

/// A rectangle around the origin, seen from the side that its normal points to. With the normal
/// along z, `size` is along x and y; other planes are this one, turned the shortest way.
[[nodiscard]] std::shared_ptr<const Mesh> planeMesh(const Eigen::Vector3d& normal,
                                                    const Eigen::Vector2d& size);

}  // namespace synthetic_dataset::world

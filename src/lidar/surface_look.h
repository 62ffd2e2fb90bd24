#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::lidar {

/// A place on a mesh.
struct SurfacePlace {
  std::size_t triangle = 0;
  double b1 = 0.0;  ///< the weight of the triangle's second corner,
  double b2 = 0.0;  ///< of its third one; the first has the rest
};

/// Whether the texture's alpha leaves a hole there.
[[nodiscard]] bool isHole(const world::Mesh& mesh, const world::Material& material,
                          const SurfacePlace& place);

/// Whether the diffuse picture has such holes at all.
[[nodiscard]] bool hasHoles(const world::Material& material);

/// Whether one can see through the surface somewhere: glass.
[[nodiscard]] bool isTransparent(const world::Mesh& mesh, const world::Material& material);

/// The normal of length 1 that the vertices have, in the mesh's frame, on the side of the triangle
/// from which a ray comes.
/// @param direction  of the ray
[[nodiscard]] Eigen::Vector3d normalAt(const world::Mesh& mesh, const SurfacePlace& place,
                                       const Eigen::Vector3d& direction);

/// How much of the light comes back to where it came from: 0 nothing .. 1, that of a matt white
/// surface that is met at right angles. A matt part (Lambert's), as bright as the surface is in
/// visible light, as no file says how bright it is in infrared, and a mirroring part around the
/// normal, the narrower the less rough it is (Cook and Torrance 1982, with Beckmann's distribution
/// and the reflectance of 0.04 that plastics have).
/// @param cosine  of the angle between ray and normal, 0 .. 1
[[nodiscard]] double intensityAt(const world::Mesh& mesh, const world::Material& material,
                                 const SurfacePlace& place, world::Simulator simulator,
                                 double cosine);

}  // namespace synthetic_dataset::lidar

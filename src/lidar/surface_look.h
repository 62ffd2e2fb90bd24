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

/// Whether the texture's alpha makes a hole there.
[[nodiscard]] bool isHole(const world::Mesh& mesh, const world::Material& material,
                          const SurfacePlace& place);

/// Whether the diffuse texture has such holes at all.
[[nodiscard]] bool hasHoles(const world::Material& material);

/// Whether the surface is transparent somewhere: glass.
[[nodiscard]] bool isTransparent(const world::Mesh& mesh, const world::Material& material);

/// The unit normal interpolated between the vertices, in the mesh's frame, on the side of the
/// triangle from which a ray comes.
/// @param direction  of the ray
[[nodiscard]] Eigen::Vector3d normalAt(const world::Mesh& mesh, const SurfacePlace& place,
                                       const Eigen::Vector3d& direction);

/// The fraction of light that is reflected back to its source: 0 for nothing .. 1 for a matt white
/// surface at normal incidence. It has a matt part (Lambert's), as bright as the surface is in
/// visible light, since no file says how bright it is in infrared, and a specular part around the
/// normal, which is narrower the less rough the surface is (Cook and Torrance 1982, with Beckmann's
/// distribution and a reflectance of 0.04, that of plastics).
/// @param cosine  of the angle between ray and normal, 0 .. 1
[[nodiscard]] double intensityAt(const world::Mesh& mesh, const world::Material& material,
                                 const SurfacePlace& place, world::Simulator simulator,
                                 double cosine);

}  // namespace synthetic_dataset::lidar

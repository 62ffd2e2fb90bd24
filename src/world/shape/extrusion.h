#pragma once

#include <memory>
#include <vector>

#include "world/description.h"
#include "world/shape/triangulation.h"

namespace synthetic_dataset::world {

/// SDF's <polyline>: the area that outlines enclose, extruded upwards from z = 0.
struct Extrusion {
  std::vector<Outline> outlines;
  double height = 1.0;  ///< [m]
};

/// The mesh, with both caps; a texture repeats every metre.
/// @throws Error as `triangulate`
[[nodiscard]] std::shared_ptr<const Mesh> extrudedMesh(const Extrusion& extrusion);

}  // namespace synthetic_dataset::world

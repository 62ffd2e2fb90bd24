#pragma once

#include <memory>
#include <vector>

#include "world/description.h"
#include "world/shape/triangulation.h"

namespace synthetic_dataset::world {

/// SDF's <polyline>: what outlines enclose, from z = 0 up.
struct Extrusion {
  std::vector<Outline> outlines;
  double height = 1.0;  ///< [m]
};

/// With both caps; a texture is repeated each metre.
/// @throws Error as `triangulate`
[[nodiscard]] std::shared_ptr<const Mesh> extrudedMesh(const Extrusion& extrusion);

}  // namespace synthetic_dataset::world

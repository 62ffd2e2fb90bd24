#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <Eigen/Core>

#include <sdf/Geometry.hh>

#include "world/sdf/sdf_reading.h"
#include "world/shape/extrusion.h"
#include "world/shape/heightmap.h"
#include "world/shape/wall_map.h"

namespace synthetic_dataset::world {

/// A finite piece of a plane.
struct PlanePatch {
  Eigen::Vector3d normal;
  Eigen::Vector2d size;  ///< [m]
};

struct Capsule {  ///< about z, centred
  double radius;
  double length;  ///< of the cylinder alone
};

struct Ellipsoid {
  Eigen::Vector3d radii;
};

/// A geometry with its numbers checked and its mesh file found.
using Geometry = std::variant<BoxShape, SphereShape, CylinderShape, PlanePatch, Capsule, Ellipsoid,
                              MeshRequest, Extrusion, Heightmap, WallMap>;

/// @return nothing for an error (reported), for a kind that is left out (noted), and for none at
/// all
[[nodiscard]] std::optional<Geometry> readGeometry(const sdf::Geometry& geometry,
                                                   const Place& place, SdfReading& reading);

}  // namespace synthetic_dataset::world

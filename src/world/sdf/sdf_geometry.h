#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include <Eigen/Core>

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

/// @param owner  of the `<geometry>`
/// @param scale  how much larger than the file says, by axis: of a saved world's `<state>`
/// @param location  the owner's
/// @return nothing for one that cannot be understood, for a kind that is left out (both noted),
///     for one whose file is missing (reported), and for none at all
[[nodiscard]] std::optional<Geometry> readGeometry(const Element& owner,
                                                   const Eigen::Vector3d& scale,
                                                   const SourceLocation& location,
                                                   SdfReading& reading);

/// Lists the mesh of a geometry, if it is one.
/// @param with_pictures  those of its own materials are wanted, too
void surveyMesh(const Geometry& geometry, bool with_pictures, SdfSurvey& survey);

}  // namespace synthetic_dataset::world

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

struct Capsule {  ///< axis along z, centred at the origin
  double radius;
  double length;  ///< of the cylinder only
};

struct Ellipsoid {
  Eigen::Vector3d radii;
};

/// A geometry with its numbers checked and its mesh file found.
using Geometry = std::variant<BoxShape, SphereShape, CylinderShape, PlanePatch, Capsule, Ellipsoid,
                              MeshRequest, Extrusion, Heightmap, WallMap>;

/// @param owner  the parent of the `<geometry>`
/// @param scale  factors on the sizes in the file, by axis, from a saved world's `<state>`
/// @param location  the owner's
/// @return nothing for a geometry that cannot be understood or whose kind is not supported (both
///     noted), for one whose file is missing (reported), or if there is none at all
[[nodiscard]] std::optional<Geometry> readGeometry(const Element& owner,
                                                   const Eigen::Vector3d& scale,
                                                   const SourceLocation& location,
                                                   SdfReading& reading);

/// Adds the mesh of a geometry, if it is one, to a survey.
/// @param with_pictures  the pictures of its own materials are needed, too
void surveyMesh(const Geometry& geometry, bool with_pictures, SdfSurvey& survey);

}  // namespace synthetic_dataset::world

#include "world/sdf/sdf_collisions.h"

#include <algorithm>
#include <string>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_geometry.h"
#include "world/sdf/sdf_values.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace {

/// Makes the shape for physics from each kind of geometry; kinds that physics does not know become
/// meshes.
struct ShapeMaker {
  SdfReading& reading;

  Shape operator()(const BoxShape& box) const { return box; }
  Shape operator()(const SphereShape& sphere) const { return sphere; }
  Shape operator()(const CylinderShape& cylinder) const { return cylinder; }
  Shape operator()(const PlanePatch& plane) const { return PlaneShape{plane.normal}; }
  Shape operator()(const Capsule& capsule) const {
    return MeshShape{reading.shapes.mesh(ShapeKind::kCapsule, {capsule.radius, capsule.length, 0})};
  }
  Shape operator()(const Ellipsoid& ellipsoid) const {
    return MeshShape{reading.shapes.mesh(ShapeKind::kEllipsoid, ellipsoid.radii)};
  }
  Shape operator()(const MeshRequest& request) const {
    return MeshShape{reading.meshes.whole(request)};
  }
  Shape operator()(const Extrusion& extrusion) const { return MeshShape{extrudedMesh(extrusion)}; }
  Shape operator()(const Heightmap& heightmap) const { return MeshShape{heightmapMesh(heightmap)}; }
  Shape operator()(const WallMap& map) const { return MeshShape{wallMesh(map)}; }
};

/// Replaces a negative value by the fallback. Gazebo, too, ignores a friction below 0.
double atLeastZero(double value, double fallback, const char* name, const SourceLocation& location,
                   SdfReading& reading) {
  if (value >= 0.0) return value;
  reading.findings.addNote(location, std::string(name) + ": found " + shortText(value) +
                                         "; it has to be 0 or more; " + takenInstead(fallback));
  return fallback;
}

void readSurface(const Element& collision, const SourceLocation& location, SdfReading& reading,
                 Collision& to) {
  const Element surface = collision.child("surface");
  const Element ode = surface.child("friction").child("ode");
  to.friction = atLeastZero(readNumber(ode, "mu", to.friction, location, reading), to.friction,
                            "friction mu", location, reading);
  const double bounce = readNumber(surface.child("bounce"), "restitution_coefficient",
                                   to.restitution, location, reading);
  to.restitution = std::min(
      1.0, atLeastZero(bounce, to.restitution, "restitution_coefficient", location, reading));
}

}  // namespace

std::optional<Collision> readCollision(const Element& collision, const Eigen::Vector3d& scale,
                                       const SourceLocation& location, SdfReading& reading) {
  Collision result;
  result.name = collision.attribute("name");
  readSurface(collision, location, reading, result);
  const std::optional<Geometry> geometry = readGeometry(collision, scale, location, reading);
  if (!geometry) return std::nullopt;
  if (reading.survey != nullptr) {
    surveyMesh(*geometry, false, *reading.survey);
    return std::nullopt;
  }
  try {
    result.shape = std::visit(ShapeMaker{reading}, *geometry);
  } catch (const Error& error) {
    reading.missing(location, error.what());
    return std::nullopt;
  }
  return result;
}

void noteHulls(const Element& link, const SourceLocation& location, SdfReading& reading) {
  for (const Element& collision : link.children("collision")) {
    for (const char* kind : {"polyline", "heightmap", "image"}) {
      if (!collision.child("geometry").has(kind)) continue;
      reading.findings.addNote(
          locationOf(collision, location),
          std::string("a ") + kind + "; while it moves, its convex hull collides");
    }
  }
}

}  // namespace synthetic_dataset::world

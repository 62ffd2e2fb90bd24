#include "world/sdf/sdf_collisions.h"

#include <algorithm>
#include <string>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_geometry.h"

namespace synthetic_dataset::world {
namespace {

/// What physics is given for each kind of geometry; those that it does not know, as meshes.
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

double atLeastZero(double value, const char* name, const Place& place, SdfReading& reading) {
  if (std::isfinite(value) && value >= 0.0) return value;
  reading.findings.addError(place.message(std::string(name) + ": found " + std::to_string(value) +
                                          "; it has to be 0 or more"));
  return 0.0;
}

void readSurface(const sdf::ElementPtr& element, const Place& place, SdfReading& reading,
                 Collision& to) {
  const sdf::ElementPtr surface = descendant(element, {"surface"});
  const double mu = number(surface, {"friction", "ode", "mu"}, to.friction);
  to.friction = atLeastZero(mu, "friction mu", place, reading);
  const double bounce = number(surface, {"bounce", "restitution_coefficient"}, to.restitution);
  to.restitution = std::min(1.0, atLeastZero(bounce, "restitution_coefficient", place, reading));
}

}  // namespace

std::optional<Collision> readCollision(const sdf::Collision& collision, const Place& place,
                                       SdfReading& reading) {
  const Place here = place.in("collision", collision.Name());
  Collision result;
  result.name = collision.Name();
  result.X_LC = resolve(collision.SemanticPose(), here, reading);
  readSurface(collision.Element(), here, reading, result);
  if (collision.Geom() == nullptr) return std::nullopt;
  const std::optional<Geometry> geometry = readGeometry(*collision.Geom(), here, reading);
  if (!geometry) return std::nullopt;
  try {
    result.shape = std::visit(ShapeMaker{reading}, *geometry);
  } catch (const Error& error) {
    reading.missing(here.message(error.what()));
    return std::nullopt;
  }
  return result;
}

void noteHulls(const sdf::Link& link, const Place& place, SdfReading& reading) {
  for (std::size_t i = 0; i < link.CollisionCount(); ++i) {
    const sdf::Collision& collision = *link.CollisionByIndex(i);
    const sdf::ElementPtr geometry = descendant(collision.Element(), {"geometry"});
    for (const char* kind : {"polyline", "heightmap", "image"}) {
      if (!has(geometry, kind)) continue;
      reading.findings.addNote(
          place.in("collision", collision.Name())
              .message(std::string("a ") + kind + "; while it moves, its convex hull collides"));
    }
  }
}

}  // namespace synthetic_dataset::world

#include "world/sdf/sdf_visuals.h"

#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_geometry.h"
#include "world/sdf/sdf_materials.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace {

/// The triangles of each kind of geometry, in the given material or, without one, in their own.
struct SurfaceMaker {
  const std::optional<Material>& material;
  const Place& place;
  SdfReading& reading;

  std::vector<Surface> one(std::shared_ptr<const Mesh> mesh) const {
    return {Surface{std::move(mesh), material.value_or(defaultMaterial())}};
  }
  std::vector<Surface> shape(ShapeKind kind, const Eigen::Vector3d& size) const {
    return one(reading.shapes.mesh(kind, size));
  }

  std::vector<Surface> operator()(const BoxShape& box) const {
    return shape(ShapeKind::kBox, box.size);
  }
  std::vector<Surface> operator()(const SphereShape& sphere) const {
    return shape(ShapeKind::kSphere, {sphere.radius, 0, 0});
  }
  std::vector<Surface> operator()(const CylinderShape& cylinder) const {
    return shape(ShapeKind::kCylinder, {cylinder.radius, cylinder.length, 0});
  }
  std::vector<Surface> operator()(const Capsule& capsule) const {
    return shape(ShapeKind::kCapsule, {capsule.radius, capsule.length, 0});
  }
  std::vector<Surface> operator()(const Ellipsoid& ellipsoid) const {
    return shape(ShapeKind::kEllipsoid, ellipsoid.radii);
  }
  std::vector<Surface> operator()(const PlanePatch& plane) const {
    return one(planeMesh(plane.normal, plane.size));
  }
  std::vector<Surface> operator()(const MeshRequest& request) const {
    const auto missing = [&](const std::string& message) {
      reading.missing(place.message(message));
    };
    std::vector<Surface> surfaces;
    for (const MeshPiece& piece : reading.meshes.pieces(request)) {
      surfaces.push_back(
          {piece.mesh,
           material ? *material : reading.meshes.material(request.file, piece.material, missing)});
    }
    return surfaces;
  }
  std::vector<Surface> operator()(const Extrusion& extrusion) const {
    return one(extrudedMesh(extrusion));
  }
  std::vector<Surface> operator()(const Heightmap& heightmap) const {
    return heightmapSurfaces(heightmap, material.value_or(defaultMaterial()),
                             reading.meshes.textures());
  }
  std::vector<Surface> operator()(const WallMap& map) const { return one(wallMesh(map)); }
};

std::optional<Material> materialOf(const sdf::Visual& visual, const Place& place,
                                   SdfReading& reading) {
  if (visual.Material() == nullptr) return std::nullopt;
  return readSdfMaterial(*visual.Material(), place, reading);
}

}  // namespace

std::optional<Visual> readVisual(const sdf::Visual& visual, const Place& place,
                                 SdfReading& reading) {
  const Place here = place.in("visual", visual.Name());
  Visual result;
  result.name = visual.Name();
  result.X_LV = resolve(visual.SemanticPose(), here, reading);
  result.casts_shadow = visual.CastShadows();
  const float transparency = visual.Transparency();
  if (!(transparency >= 0.0F && transparency <= 1.0F)) {
    reading.findings.addError(here.message("transparency: found " + std::to_string(transparency) +
                                           "; it should be 0 to 1"));
  }
  if (visual.Geom() == nullptr) return std::nullopt;
  const std::optional<Geometry> geometry = readGeometry(*visual.Geom(), here, reading);
  if (!geometry) return std::nullopt;
  const std::optional<Material> material = materialOf(visual, here, reading);
  try {
    result.surfaces = std::visit(SurfaceMaker{material, here, reading}, *geometry);
  } catch (const Error& error) {
    reading.missing(here.message(error.what()));
  }
  for (Surface& surface : result.surfaces) surface.material.diffuse.w() *= 1.0F - transparency;
  if (transparency >= 1.0F || result.surfaces.empty()) return std::nullopt;
  return result;
}

}  // namespace synthetic_dataset::world

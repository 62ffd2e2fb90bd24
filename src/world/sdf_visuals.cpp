#include "world/sdf_visuals.h"

#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/sdf_geometry.h"
#include "world/sdf_materials.h"
#include "world/shape_meshes.h"

namespace synthetic_dataset::world {
namespace {

/// The triangles of each kind of geometry, in the given material or, without one, in their own.
struct SurfaceMaker {
  const std::optional<Material>& material;
  SdfReading& reading;

  std::vector<Surface> one(std::shared_ptr<const Mesh> mesh) const {
    return {Surface{std::move(mesh), material.value_or(Material{})}};
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
    std::vector<Surface> surfaces;
    for (const MeshPiece& piece : reading.meshes.pieces(request)) {
      surfaces.push_back({piece.mesh, material
                                          ? *material
                                          : reading.meshes.material(request.file, piece.material)});
    }
    return surfaces;
  }
};

std::optional<Material> materialOf(const sdf::Visual& visual, const Geometry& geometry,
                                   const Place& place, SdfReading& reading) {
  if (visual.Material() == nullptr) return std::nullopt;
  const auto fallback = std::holds_alternative<MeshRequest>(geometry)
                            ? MaterialFallback::kMeshMaterial
                            : MaterialFallback::kDiffuseColour;
  return readSdfMaterial(*visual.Material(), fallback, place, reading);
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
  const std::optional<Material> material = materialOf(visual, *geometry, here, reading);
  try {
    result.surfaces = std::visit(SurfaceMaker{material, reading}, *geometry);
  } catch (const Error& error) {
    reading.findings.addError(here.message(error.what()));
  }
  for (Surface& surface : result.surfaces) surface.material.diffuse.w() *= 1.0F - transparency;
  if (transparency >= 1.0F || result.surfaces.empty()) return std::nullopt;
  return result;
}

}  // namespace synthetic_dataset::world

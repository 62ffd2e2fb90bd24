#include "world/sdf/sdf_visuals.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_geometry.h"
#include "world/sdf/sdf_materials.h"
#include "world/sdf/sdf_values.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace {

MissingPicture missingPictureIn(const Place& place, SdfReading& reading) {
  return [&](const std::string& message) { reading.missing(place, message); };
}

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
    return meshSurfaces(request, material, place, reading);
  }
  std::vector<Surface> operator()(const Extrusion& extrusion) const {
    return one(extrudedMesh(extrusion));
  }
  std::vector<Surface> operator()(const Heightmap& heightmap) const {
    return heightmapSurfaces(heightmap, material.value_or(defaultMaterial()),
                             reading.meshes.textures(), missingPictureIn(place, reading));
  }
  std::vector<Surface> operator()(const WallMap& map) const { return one(wallMesh(map)); }
};

float readTransparency(const Element& visual, const Place& place, SdfReading& reading) {
  const double found = readNumber(visual, "transparency", 0.0, place, reading);
  const double transparency = std::clamp(found, 0.0, 1.0);
  if (found != transparency) {
    reading.findings.addNote(place, "transparency: found " + shortText(found) +
                                        "; it should be 0 to 1; " + takenInstead(transparency));
  }
  return static_cast<float>(transparency);
}

}  // namespace

std::vector<Surface> meshSurfaces(const MeshRequest& request,
                                  const std::optional<Material>& material, const Place& place,
                                  SdfReading& reading) {
  const MissingPicture missing = missingPictureIn(place, reading);
  std::vector<Surface> surfaces;
  for (const MeshPiece& piece : reading.meshes.pieces(request)) {
    surfaces.push_back(
        {piece.mesh,
         material ? *material : reading.meshes.material(request, piece.material, missing)});
  }
  return surfaces;
}

std::optional<Visual> readVisual(const Element& visual, const Eigen::Vector3d& scale,
                                 const Place& place, SdfReading& reading) {
  Visual result;
  result.name = visual.attribute("name");
  result.casts_shadow = readBool(visual, "cast_shadows", true, place, reading);
  const float transparency = readTransparency(visual, place, reading);
  if (transparency >= 1.0F) return std::nullopt;
  const std::optional<Geometry> geometry = readGeometry(visual, scale, place, reading);
  if (!geometry) return std::nullopt;
  const std::optional<Material> material = readSdfMaterial(visual, place, reading);
  if (reading.survey != nullptr) {
    surveyMesh(*geometry, !material, *reading.survey);
    return std::nullopt;
  }
  try {
    result.surfaces = std::visit(SurfaceMaker{material, place, reading}, *geometry);
  } catch (const Error& error) {
    reading.missing(place, error.what());
  }
  for (Surface& surface : result.surfaces) surface.material.diffuse.w() *= 1.0F - transparency;
  if (result.surfaces.empty()) return std::nullopt;
  return result;
}

}  // namespace synthetic_dataset::world

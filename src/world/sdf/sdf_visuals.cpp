#include "world/sdf/sdf_visuals.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/mesh/mesh_materials.h"
#include "world/sdf/sdf_geometry.h"
#include "world/sdf/sdf_materials.h"
#include "world/sdf/sdf_values.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace {

std::shared_ptr<const Mesh> withoutColours(const std::shared_ptr<const Mesh>& mesh) {
  if (mesh->colours.empty()) return mesh;
  Mesh plain = *mesh;
  plain.colours.clear();
  return std::make_shared<Mesh>(std::move(plain));
}

MissingPicture missingPictureIn(const SourceLocation& location, SdfReading& reading) {
  return [&](const std::string& message) { reading.missing(location, message); };
}

/// The triangles of each kind of geometry, in the given material or, without one, in their own.
struct SurfaceMaker {
  const std::optional<Material>& material;
  const SourceLocation& location;
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
    return meshSurfaces(request, material, std::nullopt, location, reading);
  }
  std::vector<Surface> operator()(const Extrusion& extrusion) const {
    return one(extrudedMesh(extrusion));
  }
  std::vector<Surface> operator()(const Heightmap& heightmap) const {
    return heightmapSurfaces(heightmap, material.value_or(defaultMaterial()),
                             reading.meshes.textures(), missingPictureIn(location, reading));
  }
  std::vector<Surface> operator()(const WallMap& map) const { return one(wallMesh(map)); }
};

float readTransparency(const Element& visual, const SourceLocation& location, SdfReading& reading) {
  const double found = readNumber(visual, "transparency", 0.0, location, reading);
  const double transparency = std::clamp(found, 0.0, 1.0);
  if (found != transparency) {
    reading.findings.addNote(location, "transparency: found " + shortText(found) +
                                           "; it should be 0 to 1; " + takenInstead(transparency));
  }
  return static_cast<float>(transparency);
}

}  // namespace

std::vector<Surface> meshSurfaces(const MeshRequest& request,
                                  const std::optional<Material>& material,
                                  const std::optional<Material>& fallback,
                                  const SourceLocation& location, SdfReading& reading) {
  const MissingPicture missing = missingPictureIn(location, reading);
  const bool is_stl = extensionOf(request.file) == ".stl";
  std::vector<Surface> surfaces;
  for (const MeshPiece& piece : reading.meshes.pieces(request)) {
    const bool is_bare = reading.meshes.isDefaultMaterial(request.file, piece.material);
    const std::optional<Material>& given = material || !is_bare ? material : fallback;
    if (!given) {
      surfaces.push_back({piece.mesh, reading.meshes.material(request, piece.material, missing)});
    } else {
      surfaces.push_back({is_stl ? withoutColours(piece.mesh) : piece.mesh, *given});
    }
  }
  return surfaces;
}

std::vector<Surface> surfacesOf(const Geometry& geometry, const std::optional<Material>& material,
                                const SourceLocation& location, SdfReading& reading) {
  return std::visit(SurfaceMaker{material, location, reading}, geometry);
}

std::optional<Visual> readVisual(const Element& visual, const Eigen::Vector3d& scale,
                                 const SourceLocation& location, SdfReading& reading) {
  Visual result;
  result.name = visual.attribute("name");
  result.casts_shadow = readBool(visual, "cast_shadows", true, location, reading);
  const float transparency = readTransparency(visual, location, reading);
  if (transparency >= 1.0F) return std::nullopt;
  const std::optional<Geometry> geometry = readGeometry(visual, scale, location, reading);
  if (!geometry) return std::nullopt;
  const std::optional<Material> material = readSdfMaterial(visual, location, reading);
  if (reading.survey != nullptr) {
    surveyMesh(*geometry, !material, *reading.survey);
    return std::nullopt;
  }
  try {
    result.surfaces = surfacesOf(*geometry, material, location, reading);
  } catch (const Error& error) {
    reading.missing(location, error.what());
  }
  for (Surface& surface : result.surfaces) surface.material.diffuse.w() *= 1.0F - transparency;
  if (result.surfaces.empty()) return std::nullopt;
  return result;
}

}  // namespace synthetic_dataset::world

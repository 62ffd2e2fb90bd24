#include "world/urdf/urdf_geometry.h"

#include <cmath>
#include <utility>
#include <variant>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// A geometry with its numbers checked and its mesh file found.
using UrdfGeometry = std::variant<BoxShape, SphereShape, CylinderShape, MeshRequest>;

/// Where relative URIs of the text start.
/// @throws Error for one that is relative in a text that lies in no file
fs::path folderFor(const std::string& kind, const std::string& uri, const ModelText& source) {
  if (source.folder) return *source.folder;
  const std::size_t scheme = uri.find("://");
  const bool is_path = scheme == std::string::npos || uri.substr(0, scheme) == "file";
  const std::string path = scheme == std::string::npos ? uri : uri.substr(scheme + 3);
  if (is_path && !fs::path(path).is_absolute()) {
    throw Error(kind + " '" + uri +
                "': a relative path leads nowhere from a text that is in no file; package:// and "
                "absolute paths can be found");
  }
  return "/";
}

/// Reads one geometry. @throws Error with what is wrong with it
struct UrdfGeometryReader {
  UrdfReading& reading;

  UrdfGeometry read(const urdf::Geometry& geometry) const {
    switch (geometry.type) {
      case urdf::Geometry::BOX: {
        const urdf::Vector3& size = static_cast<const urdf::Box&>(geometry).dim;
        return BoxShape{
            {above0("box size", size.x), above0("box size", size.y), above0("box size", size.z)}};
      }
      case urdf::Geometry::SPHERE:
        return SphereShape{
            above0("sphere radius", static_cast<const urdf::Sphere&>(geometry).radius)};
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
        return CylinderShape{above0("cylinder radius", cylinder.radius),
                             above0("cylinder length", cylinder.length)};
      }
      case urdf::Geometry::MESH:
        return readMesh(static_cast<const urdf::Mesh&>(geometry));
    }
    throw Error("a kind of geometry that is not known here; box, cylinder, sphere and mesh are");
  }

 private:
  static double above0(const std::string& name, double value) {
    if (std::isfinite(value) && value > 0.0) return value;
    throw Error(name + ": found " + fixed(value, 6) + "; it has to be above 0 m");
  }

  MeshRequest readMesh(const urdf::Mesh& mesh) const {
    MeshRequest request;
    request.scale = {mesh.scale.x, mesh.scale.y, mesh.scale.z};
    if (!request.scale.allFinite() || request.scale.prod() == 0.0) {
      throw Error("mesh scale: found " + fixed(mesh.scale.x, 6) + " " + fixed(mesh.scale.y, 6) +
                  " " + fixed(mesh.scale.z, 6) + "; none of the three may be 0");
    }
    const fs::path folder = folderFor("mesh", mesh.filename, reading.source);
    const auto file = reading.finder.find(mesh.filename, folder);
    if (!file) {
      throw Error("mesh '" + mesh.filename + "': no such file; " +
                  reading.finder.searchedPlaces(mesh.filename, folder));
    }
    request.file = *file;
    return request;
  }
};

/// The triangles of each kind of geometry in their materials.
struct UrdfSurfaceMaker {
  const std::optional<Material>& gazebo_material;
  const std::optional<Material>& urdf_material;
  const SourceLocation& location;
  UrdfReading& reading;

  std::vector<Surface> shape(ShapeKind kind, const Eigen::Vector3d& size) const {
    const auto& material = gazebo_material ? gazebo_material : urdf_material;
    return {Surface{reading.shapes.mesh(kind, size), material.value_or(defaultMaterial())}};
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
  std::vector<Surface> operator()(const MeshRequest& request) const {
    std::vector<Surface> surfaces;
    for (const MeshPiece& piece : reading.meshes.pieces(request)) {
      surfaces.push_back({piece.mesh, materialOf(request, piece)});
    }
    if (reading.meshes.saysYUp(request.file)) {
      reading.y_up_meshes.insert(request.file.filename().string());
    }
    return surfaces;
  }
  Material materialOf(const MeshRequest& request, const MeshPiece& piece) const {
    if (gazebo_material) return *gazebo_material;
    if (urdf_material && reading.meshes.isMadeUp(request.file, piece.material)) {
      return *urdf_material;
    }
    return reading.meshes.material(request, piece.material, [&](const std::string& message) {
      reading.findings.addMissing(location, message);
    });
  }
};

struct UrdfShapeMaker {
  UrdfReading& reading;

  Shape operator()(const BoxShape& box) const { return box; }
  Shape operator()(const SphereShape& sphere) const { return sphere; }
  Shape operator()(const CylinderShape& cylinder) const { return cylinder; }
  Shape operator()(const MeshRequest& request) const {
    return MeshShape{reading.meshes.whole(request)};
  }
};

/// As in rviz, a texture takes the place of the colour.
/// urdfdom passes over colours with numbers beyond 0 to 1; they count as the nearest.
/// @throws Error where the picture is missing or cannot be decoded
Material toMaterial(const urdf::Material& from, UrdfReading& reading) {
  Material material;
  material.diffuse = {from.color.r, from.color.g, from.color.b, from.color.a};
  if (!material.diffuse.allFinite()) material.diffuse = Material().diffuse;
  material.diffuse = material.diffuse.cwiseMax(0.0F).cwiseMin(1.0F);
  material.ambient = material.diffuse.head<3>();
  if (from.texture_filename.empty()) return material;
  material.diffuse.head<3>().setOnes();
  material.ambient.setOnes();
  const fs::path folder = folderFor("texture", from.texture_filename, reading.source);
  TextureReference reference;
  reference.uri = from.texture_filename;
  reference.folder = folder;
  material.texture = reading.meshes.textures().load(reference);
  return material;
}

}  // namespace

Pose toPose(const urdf::Pose& pose, const SourceLocation& location, UrdfReading& reading) {
  const Eigen::Vector3d position(pose.position.x, pose.position.y, pose.position.z);
  const Eigen::Quaterniond rotation(pose.rotation.w, pose.rotation.x, pose.rotation.y,
                                    pose.rotation.z);
  if (position.allFinite() && rotation.coeffs().allFinite()) return makePose(position, rotation);
  reading.findings.addError(location.message("its <origin> has a number that is not finite"));
  return Pose::Identity();
}

std::optional<Visual> readUrdfVisual(const urdf::Visual& visual, const std::string& name,
                                     const std::optional<Material>& gazebo_material,
                                     const SourceLocation& location, UrdfReading& reading) {
  const SourceLocation here = location.in("visual", name);
  Visual result;
  result.name = name;
  result.X_LV = toPose(visual.origin, here, reading);
  try {
    const UrdfGeometry geometry = UrdfGeometryReader{reading}.read(*visual.geometry);
    std::optional<Material> material;
    if (visual.material && !gazebo_material) material = toMaterial(*visual.material, reading);
    if (material && material->diffuse.w() == 0.0F) return std::nullopt;  // made to be invisible
    result.surfaces =
        std::visit(UrdfSurfaceMaker{gazebo_material, material, here, reading}, geometry);
  } catch (const Error& error) {
    reading.findings.addMissing(here, error.what());
    return std::nullopt;
  }
  return result;
}

std::optional<Collision> readUrdfCollision(const urdf::Collision& collision,
                                           const std::string& name, const SourceLocation& location,
                                           UrdfReading& reading) {
  const SourceLocation here = location.in("collision", name);
  Collision result;
  result.name = name;
  result.X_LC = toPose(collision.origin, here, reading);
  try {
    result.shape =
        std::visit(UrdfShapeMaker{reading}, UrdfGeometryReader{reading}.read(*collision.geometry));
  } catch (const Error& error) {
    reading.findings.addMissing(here, error.what());
    return std::nullopt;
  }
  return result;
}

}  // namespace synthetic_dataset::world

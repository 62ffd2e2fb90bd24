#include "world/sdf_geometry.h"

#include <utility>

#include <sdf/sdf_config.h>
#include <sdf/Box.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Mesh.hh>
#include <sdf/Plane.hh>
#include <sdf/Sphere.hh>
#if SDF_MAJOR_VERSION >= 11
#include <sdf/Capsule.hh>
#include <sdf/Ellipsoid.hh>
#endif

#include "synthetic_dataset/label_text.h"
#include "world/sdf_document.h"

namespace synthetic_dataset::world {
namespace {

/// Reads one geometry; notes what is wrong with it.
class GeometryReader {
 public:
  GeometryReader(const sdf::Geometry& geometry, const Place& place, SdfReading& reading)
      : geometry_(geometry), place_(place), reading_(reading) {}

  std::optional<Geometry> read() {
    std::optional<Geometry> result = readKind();
    if (!sizes_good_) return std::nullopt;
    return result;
  }

 private:
  std::optional<Geometry> readKind() {
    switch (geometry_.Type()) {
      case sdf::GeometryType::BOX:
        return BoxShape{sizes("box size", toEigen(geometry_.BoxShape()->Size()))};
      case sdf::GeometryType::SPHERE:
        return SphereShape{size("sphere radius", geometry_.SphereShape()->Radius())};
      case sdf::GeometryType::CYLINDER:
        return CylinderShape{size("cylinder radius", geometry_.CylinderShape()->Radius()),
                             size("cylinder length", geometry_.CylinderShape()->Length())};
      case sdf::GeometryType::PLANE:
        return readPlane(*geometry_.PlaneShape());
      case sdf::GeometryType::MESH:
        return readMesh(*geometry_.MeshShape());
#if SDF_MAJOR_VERSION >= 11
      case sdf::GeometryType::CAPSULE:
        return Capsule{size("capsule radius", geometry_.CapsuleShape()->Radius()),
                       size("capsule length", geometry_.CapsuleShape()->Length())};
      case sdf::GeometryType::ELLIPSOID:
        return Ellipsoid{sizes("ellipsoid radii", toEigen(geometry_.EllipsoidShape()->Radii()))};
#endif
      default:
        return leaveOut();
    }
  }

  double size(const std::string& name, double value) {
    if (std::isfinite(value) && value > 0.0) return value;
    sizes_good_ = false;
    reading_.findings.addError(
        place_.message(name + ": found " + fixed(value, 6) + "; it has to be above 0 m"));
    return 1.0;
  }

  Eigen::Vector3d sizes(const std::string& name, const Eigen::Vector3d& values) {
    return {size(name, values.x()), size(name, values.y()), size(name, values.z())};
  }

  std::optional<Geometry> readPlane(const sdf::Plane& plane) {
    const Eigen::Vector3d normal = toEigen(plane.Normal());
    size("length of the plane's normal", normal.norm());
    return PlanePatch{normal.normalized(),
                      {size("plane size", plane.Size().X()), size("plane size", plane.Size().Y())}};
  }

  std::optional<Geometry> readMesh(const sdf::Mesh& mesh) {
    MeshRequest request;
    request.scale = toEigen(mesh.Scale());
    request.submesh = mesh.Submesh();
    request.centre_submesh = mesh.CenterSubmesh();
    if (!request.scale.allFinite() || request.scale.prod() == 0.0) {
      reading_.findings.addError(place_.message(
          "mesh scale: found " + fixed(request.scale.x(), 6) + " " + fixed(request.scale.y(), 6) +
          " " + fixed(request.scale.z(), 6) + "; none of the three may be 0"));
      return std::nullopt;
    }
    const std::filesystem::path folder = reading_.folderOf(mesh.Element());
    const auto file = reading_.finder.find(mesh.Uri(), folder);
    if (!file) {
      reading_.findings.addError(
          place_.message("mesh '" + mesh.Uri() + "': no such file; " +
                         reading_.finder.searchedPlaces(mesh.Uri(), folder)));
      return std::nullopt;
    }
    request.file = *file;
    return request;
  }

  std::optional<Geometry> leaveOut() {
    const sdf::ElementPtr element = geometry_.Element();
    const sdf::ElementPtr kind = element ? element->GetFirstElement() : nullptr;
    if (kind && kind->GetName() != "empty") {
      reading_.findings.addNote(
          place_.message("its geometry, a '" + kind->GetName() + "', is left out"));
    }
    return std::nullopt;
  }

  const sdf::Geometry& geometry_;
  const Place& place_;
  SdfReading& reading_;
  bool sizes_good_ = true;
};

}  // namespace

std::optional<Geometry> readGeometry(const sdf::Geometry& geometry, const Place& place,
                                     SdfReading& reading) {
  return GeometryReader(geometry, place, reading).read();
}

}  // namespace synthetic_dataset::world

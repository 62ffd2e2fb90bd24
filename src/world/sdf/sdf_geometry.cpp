#include "world/sdf/sdf_geometry.h"

#include <sstream>
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

#include "world/sdf/sdf_element_geometry.h"

namespace synthetic_dataset::world {
namespace {

/// Reads one geometry; notes what is wrong with it.
class GeometryReader {
 public:
  GeometryReader(const sdf::Geometry& geometry, const Place& place, SdfReading& reading)
      : geometry_(geometry), place_(place), reading_(reading) {}

  std::optional<Geometry> read() {
    const std::size_t errors_before = reading_.findings.errors.size();
    std::optional<Geometry> result = readKind();
    if (reading_.findings.errors.size() != errors_before) return std::nullopt;
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
        return readElement();
    }
  }

  double size(const std::string& name, double value) {
    return readSize(name, value, place_, reading_);
  }

  Eigen::Vector3d sizes(const std::string& name, const Eigen::Vector3d& values) {
    return {size(name, values.x()), size(name, values.y()), size(name, values.z())};
  }

  std::optional<Geometry> readPlane(const sdf::Plane& plane) {
    const Eigen::Vector3d normal = toEigen(plane.Normal());
    size("length of the plane's normal", normal.norm());
    return PlanePatch{normal.normalized(),
                      {planeSize(plane.Size().X()), planeSize(plane.Size().Y())}};
  }

  /// Planes as good as endless are drawn as far as anybody sees.
  double planeSize(double value) {
    constexpr double kEndless = 1e5;  // [m]
    if (std::isfinite(value) && value > kEndless) {
      reading_.findings.addNote(place_.message("its plane is drawn 100 km wide"));
      return kEndless;
    }
    return size("plane size", value);
  }

  std::optional<Geometry> readMesh(const sdf::Mesh& mesh) {
    MeshRequest request;
    request.scale = toEigen(mesh.Scale());
    request.submesh = mesh.Submesh();
    request.centre_submesh = mesh.CenterSubmesh();
    constexpr double kLargestScale = 1e6;
    if (!request.scale.allFinite() || request.scale.prod() == 0.0 ||
        request.scale.cwiseAbs().maxCoeff() > kLargestScale) {
      std::ostringstream found;
      found << std::fixed << request.scale.transpose();
      reading_.findings.addError(place_.message("mesh scale: found " + found.str() +
                                                "; none of the three may be 0 or beyond 1e6"));
      return std::nullopt;
    }
    const auto file = readFile("mesh", mesh.Uri(), mesh.Element(), place_, reading_);
    if (!file) return std::nullopt;
    request.file = *file;
    return request;
  }

  std::optional<Geometry> readElement() {
    const sdf::ElementPtr element = geometry_.Element();
    if (has(element, "polyline")) return readPolylines(element, place_, reading_);
    if (has(element, "heightmap")) {
      return readHeightmap(element->GetElement("heightmap"), place_, reading_);
    }
    if (has(element, "image")) {
      return readWallMap(element->GetElement("image"), place_, reading_);
    }
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
};

}  // namespace

std::optional<Geometry> readGeometry(const sdf::Geometry& geometry, const Place& place,
                                     SdfReading& reading) {
  return GeometryReader(geometry, place, reading).read();
}

}  // namespace synthetic_dataset::world

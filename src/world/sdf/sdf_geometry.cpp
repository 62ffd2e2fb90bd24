#include "world/sdf/sdf_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_picture_geometry.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

/// Reads one geometry. A fault in it is thrown as an Error, which affects only its owner.
class GeometryReader {
 public:
  GeometryReader(const Element& geometry, const Eigen::Vector3d& scale,
                 const SourceLocation& location, SdfReading& reading)
      : geometry_(geometry), scale_(scale), location_(location), reading_(reading) {}

  std::optional<Geometry> read() {
    if (const Element box = geometry_.child("box")) return readBox(box);
    if (const Element sphere = geometry_.child("sphere")) return readSphere(sphere);
    if (const Element cylinder = geometry_.child("cylinder")) return readCylinder(cylinder);
    if (const Element capsule = geometry_.child("capsule")) return readCapsule(capsule);
    if (const Element ellipsoid = geometry_.child("ellipsoid")) return readEllipsoid(ellipsoid);
    if (const Element plane = geometry_.child("plane")) return readPlane(plane);
    if (const Element mesh = geometry_.child("mesh")) return readMesh(mesh);
    if (geometry_.has("polyline")) return readPolylines(geometry_, scale_, location_, reading_);
    if (const Element map = geometry_.child("heightmap")) {
      return readHeightmap(map, scale_, location_, reading_);
    }
    if (const Element image = geometry_.child("image"))
      return readWallMap(image, location_, reading_);
    noteUnknown();
    return std::nullopt;
  }

 private:
  double number(const Element& element, const char* name, double fallback) {
    return readNumber(element, name, fallback, location_, reading_);
  }

  Eigen::Vector3d scaled(const std::string& name, const Eigen::Vector3d& sizes) {
    const Eigen::Vector3d result = sizes.cwiseProduct(scale_);
    return {requireSize(name, result.x()), requireSize(name, result.y()),
            requireSize(name, result.z())};
  }

  /// A radius is scaled by the larger of two scales, as in Gazebo.
  double scaledRadius(const std::string& name, double radius) {
    return requireSize(name, radius * std::max(scale_.x(), scale_.y()));
  }

  double scaledLength(const std::string& name, double length) {
    return requireSize(name, length * scale_.z());
  }

  Geometry readBox(const Element& box) {
    return BoxShape{scaled("box size", readVector(box, "size", {1, 1, 1}, location_, reading_))};
  }

  Geometry readSphere(const Element& sphere) {
    return SphereShape{
        requireSize("sphere radius", number(sphere, "radius", 1.0) * scale_.maxCoeff())};
  }

  Geometry readCylinder(const Element& cylinder) {
    return CylinderShape{scaledRadius("cylinder radius", number(cylinder, "radius", 1.0)),
                         scaledLength("cylinder length", number(cylinder, "length", 1.0))};
  }

  Geometry readCapsule(const Element& capsule) {
    return Capsule{scaledRadius("capsule radius", number(capsule, "radius", 0.5)),
                   scaledLength("capsule length", number(capsule, "length", 1.0))};
  }

  Geometry readEllipsoid(const Element& ellipsoid) {
    return Ellipsoid{
        scaled("ellipsoid radii", readVector(ellipsoid, "radii", {1, 1, 1}, location_, reading_))};
  }

  Geometry readPlane(const Element& plane) {
    const Eigen::Vector3d normal = readVector(plane, "normal", {0, 0, 1}, location_, reading_);
    requireSize("length of the plane's normal", normal.norm());
    std::vector<double> size = numbersIn(plane.value("size").value_or("1 1"));
    if (size.size() != 2) throw Error("plane size: two numbers are needed");
    return PlanePatch{normal.normalized(),
                      {planeSize(size[0] * scale_.x()), planeSize(size[1] * scale_.y())}};
  }

  /// Practically endless planes are drawn as far as anybody can see.
  double planeSize(double value) {
    constexpr double kEndless = 1e5;  // [m]
    if (!std::isfinite(value) || value <= kEndless) return requireSize("plane size", value);
    reading_.findings.addNote(location_, "its plane is drawn 100 km wide");
    return kEndless;
  }

  std::optional<Geometry> readMesh(const Element& mesh) {
    MeshRequest request;
    const Eigen::Vector3d scale = readVector(mesh, "scale", {1, 1, 1}, location_, reading_);
    request.scale = scale.cwiseProduct(scale_);
    request.submesh = readText(mesh.child("submesh"), "name");
    request.centre_submesh = readBool(mesh.child("submesh"), "center", false, location_, reading_);
    constexpr double kLargestScale = 1e6;
    if (request.scale.prod() == 0.0 || request.scale.cwiseAbs().maxCoeff() > kLargestScale) {
      throw Error("mesh scale: found " + shortText(request.scale.x()) + " " +
                  shortText(request.scale.y()) + " " + shortText(request.scale.z()) +
                  "; none of the three may be 0 or beyond 1e6");
    }
    // SDF 1.0 writes `filename`.
    const char* name = mesh.value("uri") ? "uri" : "filename";
    const auto file = findFile("mesh", readText(mesh, name), mesh, location_, reading_);
    if (!file) return std::nullopt;
    request.file = *file;
    return request;
  }

  void noteUnknown() {
    const Element kind = geometry_.firstChild();
    if (!kind || kind.name() == "empty") return;
    reading_.findings.addNote(location_, "its geometry, a '" + kind.name() + "', is left out");
  }

  const Element& geometry_;
  const Eigen::Vector3d& scale_;
  const SourceLocation& location_;
  SdfReading& reading_;
};

}  // namespace

std::optional<Geometry> readGeometry(const Element& owner, const Eigen::Vector3d& scale,
                                     const SourceLocation& location, SdfReading& reading) {
  const Element geometry = owner.child("geometry");
  if (!geometry) return std::nullopt;
  try {
    return GeometryReader(geometry, scale, location, reading).read();
  } catch (const Error& error) {
    reading.findings.addNote(location, std::string(error.what()) + "; it is left out");
    return std::nullopt;
  }
}

void surveyMesh(const Geometry& geometry, bool with_pictures, SdfSurvey& survey) {
  const auto* mesh = std::get_if<MeshRequest>(&geometry);
  if (mesh != nullptr) survey.meshes.push_back({mesh->file, with_pictures});
}

}  // namespace synthetic_dataset::world

#include "world/urdf/urdf_visuals.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_collisions.h"
#include "world/sdf/sdf_geometry.h"
#include "world/sdf/sdf_values.h"
#include "world/sdf/sdf_visuals.h"

namespace synthetic_dataset::world {
namespace {

const Eigen::Vector3d kUnitScale{1, 1, 1};

bool hasContent(const Element& material) {
  return material.has("color") || material.has("texture");
}

std::string nameOr(const Element& element, std::size_t index) {
  const std::string name = element.attribute("name");
  return name.empty() ? std::to_string(index + 1) : name;
}

/// What a geometry lacks or has wrong, if URDF has no default for it; empty if there is nothing.
std::string missingIn(const Element& owner) {
  using Numbers = std::vector<std::pair<const char*, std::size_t>>;
  static const std::map<std::string, Numbers> kNeeded = {
      {"box", {{"size", 3}}},
      {"sphere", {{"radius", 1}}},
      {"cylinder", {{"radius", 1}, {"length", 1}}},
      {"capsule", {{"radius", 1}, {"length", 1}}},
      {"mesh", {{"filename", 0}}}};
  const Element kind = owner.child("geometry").firstChild();
  if (!kind) return "has no geometry";
  const auto needed = kNeeded.find(kind.name());
  if (needed == kNeeded.end()) return "";
  for (const auto& [name, count] : needed->second) {
    const auto given = kind.value(name);
    const std::string its = "its " + kind.name();
    if (!given) return its + " has no " + name;
    if (count == 0 || numbersIn(*given).size() == count) continue;
    return its + "'s " + name + " is '" + *given + "'; it should be " + std::to_string(count) +
           (count == 1 ? " number" : " numbers");
  }
  return "";
}

/// Reads a geometry. One with something missing is left out, with a note.
std::optional<Geometry> geometryOf(const Element& owner, const SourceLocation& location,
                                   SdfReading& reading) {
  const std::string missing = missingIn(owner);
  if (missing.empty()) return readGeometry(owner, kUnitScale, location, reading);
  reading.findings.addNote(location, missing + "; it is left out");
  return std::nullopt;
}

}  // namespace

// The order of operations is urdfdom's: poses are the same to the last bit.
Pose readUrdfOrigin(const Element& parent, const SourceLocation& location, SdfReading& reading) {
  const Element origin = parent.child("origin");
  const Eigen::Vector3d zero(0, 0, 0);
  const Eigen::Vector3d xyz = readVector(origin, "xyz", zero, location, reading);
  const Eigen::Vector3d half = readVector(origin, "rpy", zero, location, reading) / 2.0;
  const Eigen::Vector3d s(std::sin(half[0]), std::sin(half[1]), std::sin(half[2]));
  const Eigen::Vector3d c(std::cos(half[0]), std::cos(half[1]), std::cos(half[2]));
  double x = s[0] * c[1] * c[2] - c[0] * s[1] * s[2];
  double y = c[0] * s[1] * c[2] + s[0] * c[1] * s[2];
  double z = c[0] * c[1] * s[2] - s[0] * s[1] * c[2];
  double w = c[0] * c[1] * c[2] + s[0] * s[1] * s[2];
  const double norm = std::sqrt(x * x + y * y + z * z + w * w);
  x /= norm;
  y /= norm;
  z /= norm;
  w /= norm;
  return makePose(xyz, Eigen::Quaterniond(w, x, y, z));
}

UrdfShapeReader::UrdfShapeReader(const Element& robot, SdfReading& reading) : reading_(reading) {
  for (const Element& material : robot.children("material")) define(material);
  for (const Element& link : robot.children("link")) {
    for (const Element& visual : link.children("visual")) define(visual.child("material"));
  }
}

void UrdfShapeReader::define(const Element& material) {
  const std::string name = material.attribute("name");
  if (!name.empty() && hasContent(material)) materials_.emplace(name, material);
}

/// As in rviz, a texture replaces the colour. Nothing if the file gives neither.
std::optional<Material> UrdfShapeReader::material(const Element& visual, const SourceLocation& link,
                                                  const SourceLocation& location) {
  Element element = visual.child("material");
  const std::string name = element.attribute("name");
  const auto defined = materials_.find(name);
  if (defined != materials_.end()) element = defined->second;
  if (!hasContent(element)) {
    if (!name.empty()) {
      reading_.findings.addNote(link.atLine(element.line()),
                                "the material '" + name +
                                    "' is defined nowhere; drawn in the default colour (give it a "
                                    "<color> or a <texture>)");
    }
    return std::nullopt;
  }
  Material material;
  material.diffuse = readColour(element, "color", location, reading_).value_or(material.diffuse);
  material.ambient = material.diffuse.head<3>();
  const Element texture = element.child("texture");
  if (!texture) return material;
  material.diffuse.head<3>().setOnes();
  material.ambient.setOnes();
  TextureReference reference;
  reference.uri = texture.attribute("filename");
  reference.folder = element.folder();
  material.texture = reading_.meshes.textures().load(reference);
  return material;
}

std::optional<Visual> UrdfShapeReader::visual(const Element& element, const GazeboLook& look,
                                              const SourceLocation& link,
                                              const SourceLocation& location) {
  Visual result;
  result.X_LV = readUrdfOrigin(element, location, reading_);
  result.casts_shadow = look.casts_shadow;
  const std::optional<Geometry> geometry = geometryOf(element, location, reading_);
  if (!geometry) return std::nullopt;
  try {
    std::optional<Material> own;
    if (!look.material) own = material(element, link, location);
    if (own && own->diffuse.w() == 0.0F) return std::nullopt;  // made to be invisible
    const auto* mesh = std::get_if<MeshRequest>(&*geometry);
    result.surfaces = mesh != nullptr ? meshSurfaces(*mesh, look.material, own, location, reading_)
                                      : surfacesOf(*geometry, look.material ? look.material : own,
                                                   location, reading_);
    if (mesh != nullptr && reading_.meshes.saysYUp(mesh->file)) {
      y_up_meshes_.insert(mesh->file.filename().string());
    }
  } catch (const Error& error) {
    reading_.missing(location, error.what());
    return std::nullopt;
  }
  for (Surface& surface : result.surfaces) surface.material.diffuse.w() *= 1.0F - look.transparency;
  return result;
}

std::vector<Visual> UrdfShapeReader::visuals(const Element& link, const GazeboLook& look,
                                             const SourceLocation& location) {
  std::vector<Visual> visuals;
  if (look.transparency >= 1.0F) return visuals;
  const std::vector<Element> elements = link.children("visual");
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::string name = nameOr(elements[i], i);
    auto read = visual(elements[i], look, location, locationOf(elements[i], location, name));
    if (!read || read->surfaces.empty()) continue;
    read->name = name;
    visuals.push_back(std::move(*read));
  }
  return visuals;
}

std::vector<Collision> UrdfShapeReader::collisions(const Element& link,
                                                   const SourceLocation& location) {
  std::vector<Collision> collisions;
  const std::vector<Element> elements = link.children("collision");
  const OnMissingAsset before =
      std::exchange(reading_.findings.on_missing_asset, OnMissingAsset::kWarn);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::string name = nameOr(elements[i], i);
    const SourceLocation here = locationOf(elements[i], location, name);
    const std::string missing = missingIn(elements[i]);
    if (!missing.empty()) {
      reading_.findings.addNote(here, missing + "; it is left out");
      continue;
    }
    auto read = readCollision(elements[i], kUnitScale, here, reading_);
    if (!read) continue;
    read->name = name;
    read->X_LC = readUrdfOrigin(elements[i], here, reading_);
    collisions.push_back(std::move(*read));
  }
  reading_.findings.on_missing_asset = before;
  return collisions;
}

}  // namespace synthetic_dataset::world

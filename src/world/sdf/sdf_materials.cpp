#include "world/sdf/sdf_materials.h"

#include <cmath>
#include <string>

#include "world/material/material_source.h"
#include "world/material/shininess.h"
#include "world/sdf/sdf_pbr.h"
#include "world/sdf/sdf_scripts.h"

namespace synthetic_dataset::world {
namespace {

bool hasColour(const sdf::ElementPtr& element) {
  return has(element, "ambient") || has(element, "diffuse") || has(element, "specular") ||
         has(element, "emissive");
}

/// Colours beyond 0 .. 1 mean nothing on a surface.
Eigen::Vector4f unit(const Eigen::Vector4f& colour, const char* name, const Place& place,
                     SdfReading& reading) {
  if (colour.allFinite()) return colour.cwiseMax(0.0F).cwiseMin(1.0F);
  reading.findings.addError(
      place.message(std::string(name) + ": found a number that is not finite; colours are 0 to 1"));
  return Eigen::Vector4f::Ones();
}

void readColours(const sdf::Material& from, const Place& place, SdfReading& reading, Material& to) {
  const sdf::ElementPtr element = from.Element();
  if (has(element, "ambient")) {
    to.ambient = unit(toColour(from.Ambient()), "ambient", place, reading).head<3>();
  }
  if (has(element, "diffuse")) {
    to.diffuse = unit(toColour(from.Diffuse()), "diffuse", place, reading);
  }
  if (has(element, "specular")) {
    to.specular = unit(toColour(from.Specular()), "specular", place, reading).head<3>();
  }
  if (has(element, "emissive")) {
    to.emissive = unit(toColour(from.Emissive()), "emissive", place, reading).head<3>();
  }
}

/// The exponent of the highlight, which has no colour where none is said (SDF specification,
/// <shininess>, <specular>).
void readShininess(const sdf::ElementPtr& element, Material& to) {
  const double exponent = number(element, {"shininess"}, 0.0);
  if (!(exponent > 0.0) || !std::isfinite(exponent)) return;
  to.shininess = static_cast<float>(exponent);
  to.roughness = roughnessOfShininess(to.shininess);
  if (!has(element, "specular")) to.specular.setZero();
}

/// <shader type="normal_map_tangent_space"><normal_map>
void readShader(const sdf::Material& from, SdfReading& reading, MaterialSource& to) {
  const sdf::ElementPtr map = descendant(from.Element(), {"shader", "normal_map"});
  if (!map || to.normal_map) return;
  if (from.Shader() != sdf::ShaderType::NORMAL_MAP_TANGENTSPACE) {
    if (from.Shader() == sdf::ShaderType::NORMAL_MAP_OBJECTSPACE) {
      reading.findings.addNote(
          "normal maps in object space are not drawn; those in tangent space are");
    }
    return;
  }
  const auto uri = map->Get<std::string>();
  if (uri.empty() || uri == "__default__") return;
  to.normal_map.emplace();
  to.normal_map->uri = uri;
  to.normal_map->folder = reading.folderOf(from.Element());
}

void readSwitches(const sdf::Material& from, Material& to) {
  const sdf::ElementPtr element = from.Element();
  if (const auto lighting = descendant(element, {"lighting"})) to.lit = lighting->Get<bool>();
  if (const auto both = descendant(element, {"double_sided"})) to.double_sided = both->Get<bool>();
}

/// The pictures that the source names join those that its material has of a script.
Material withMaps(const MaterialSource& source, const Place& place, SdfReading& reading) {
  const auto missing = [&](const std::string& message) { reading.missing(place.message(message)); };
  const Material loaded = withPictures(source, reading.meshes.textures(), missing);
  Material material = source.material;
  const auto take = [](const auto& from, auto& to) {
    if (from) to = from;
  };
  take(loaded.texture, material.texture);
  take(loaded.normal_map, material.normal_map);
  take(loaded.roughness_map, material.roughness_map);
  take(loaded.metalness_map, material.metalness_map);
  take(loaded.emissive_map, material.emissive_map);
  return material;
}

}  // namespace

std::optional<Material> readSdfMaterial(const sdf::Material& material, const Place& place,
                                        SdfReading& reading) {
  const sdf::ElementPtr element = material.Element();
  const std::optional<Material> script = readSdfScript(element, place, reading);
  MaterialSource source;
  if (script) source.material = *script;
  readColours(material, place, reading, source.material);
  readShininess(element, source.material);
  const bool has_pbr = readPbr(material, place, reading, source);
  reading.is_of_gz |= has_pbr;
  if (!script && !has_pbr && !hasColour(element)) return std::nullopt;
  readShader(material, reading, source);
  readSwitches(material, source.material);
  return withMaps(source, place, reading);
}

}  // namespace synthetic_dataset::world

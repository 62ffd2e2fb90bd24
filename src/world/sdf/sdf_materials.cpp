#include "world/sdf/sdf_materials.h"

#include <string>

#include "world/material/material_source.h"
#include "world/material/shininess.h"
#include "world/sdf/sdf_pbr.h"
#include "world/sdf/sdf_scripts.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

bool hasColour(const Element& material) {
  return material.has("ambient") || material.has("diffuse") || material.has("specular") ||
         material.has("emissive");
}

void readColours(const Element& from, const SourceLocation& location, SdfReading& reading,
                 Material& to) {
  const auto colour = [&](const char* name) { return readColour(from, name, location, reading); };
  if (const auto ambient = colour("ambient")) to.ambient = ambient->head<3>();
  to.diffuse = colour("diffuse").value_or(to.diffuse);
  if (const auto specular = colour("specular")) to.specular = specular->head<3>();
  if (const auto emissive = colour("emissive")) to.emissive = emissive->head<3>();
}

/// The exponent of the highlight, which has no colour where none is said (SDF specification,
/// <shininess>, <specular>).
void readShininess(const Element& element, const SourceLocation& location, SdfReading& reading,
                   Material& to) {
  const double exponent = readNumber(element, "shininess", 0.0, location, reading);
  if (!(exponent > 0.0)) return;
  to.shininess = static_cast<float>(exponent);
  to.roughness = roughnessOfShininess(to.shininess);
  if (!element.has("specular")) to.specular.setZero();
}

/// <shader type="normal_map_tangent_space"><normal_map>
void readShader(const Element& from, SdfReading& reading, MaterialSource& to) {
  const Element shader = from.child("shader");
  const std::string uri = readText(shader, "normal_map");
  const std::string type = shader.attribute("type");
  if (uri.empty() || to.normal_map) return;
  if (type == "normal_map_object_space" || type == "normal_map_objectspace") {
    reading.findings.addNote(
        "normal maps in object space are not drawn; those in tangent space are");
  }
  if (type != "normal_map_tangent_space" && type != "normal_map_tangentspace") return;
  to.normal_map.emplace();
  to.normal_map->uri = uri;
  to.normal_map->folder = from.folder();
}

/// The pictures that the source names join those that its material has of a script.
Material withMaps(const MaterialSource& source, const SourceLocation& location,
                  SdfReading& reading) {
  const auto missing = [&](const std::string& message) { reading.missing(location, message); };
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

std::optional<Material> readSdfMaterial(const Element& visual, const SourceLocation& location,
                                        SdfReading& reading) {
  const Element element = visual.child("material");
  if (!element) return std::nullopt;
  const std::optional<Material> script = readSdfScript(element, location, reading);
  MaterialSource source;
  if (script) source.material = *script;
  readColours(element, location, reading, source.material);
  readShininess(element, location, reading, source.material);
  const bool has_pbr = readPbr(element, location, reading, source);
  reading.is_of_gz |= has_pbr;
  if (!script && !has_pbr && !hasColour(element)) return std::nullopt;
  if (has_pbr || hasColour(element)) source.material.is_default = false;
  readShader(element, reading, source);
  source.material.lit = readBool(element, "lighting", source.material.lit, location, reading);
  source.material.double_sided =
      readBool(element, "double_sided", source.material.double_sided, location, reading);
  if (reading.survey == nullptr) return withMaps(source, location, reading);
  reading.survey->addPicturesOf(source);
  return source.material;
}

}  // namespace synthetic_dataset::world

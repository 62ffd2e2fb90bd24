#include "world/sdf/sdf_materials.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/files/text.h"
#include "world/material/gazebo_materials.h"
#include "world/material/material_conversions.h"
#include "world/material/material_scripts.h"
#include "world/material/material_source.h"
#include "world/sdf/sdf_reading.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

class PbrReader {
 public:
  PbrReader(const Element& material, const Element& workflow, const SourceLocation& location,
            SdfReading& reading, MaterialSource& to)
      : material_(material), pbr_(workflow), location_(location), reading_(reading), to_(to) {}

  void read() {
    readColours();
    if (pbr_.name() == "metal") {
      readMetal();
    } else {
      readSpecular();
    }
    readNormalMap();
    noteTheRest();
  }

 private:
  /// Maps are named relative to the file that names them.
  std::optional<TextureReference> picture(const char* name, PictureContent content) const {
    const std::string uri = readText(pbr_, name);
    if (uri.empty()) return std::nullopt;
    TextureReference reference;
    reference.uri = uri;
    reference.folder = pbr_.folder();
    reference.content = content;
    return reference;
  }

  float fraction(const char* name, double fallback) const {
    const double value = readNumber(pbr_, name, fallback, location_, reading_);
    if (value >= 0.0 && value <= 1.0) return static_cast<float>(value);
    reading_.findings.addNote(location_, std::string(name) + ": found " + shortText(value) +
                                             "; it should be 0 to 1; " + takenInstead(fallback));
    return static_cast<float>(fallback);
  }

  void readColours() {
    to_.texture = picture("albedo_map", PictureContent::kColour);
    if (to_.texture) {
      to_.texture->alpha = AlphaMeaning::kOpacity;  // as gz-sim draws it
      if (!material_.has("diffuse")) to_.material.diffuse.setOnes();
    }
    to_.emissive_map = picture("emissive_map", PictureContent::kColour);
    if (to_.emissive_map && !material_.has("emissive")) to_.material.emissive.setOnes();
  }

  /// A map replaces the number, and varies over the surface.
  void readMetal() {
    to_.roughness_map = picture("roughness_map", PictureContent::kRed);
    to_.metalness_map = picture("metalness_map", PictureContent::kRed);
    to_.material.roughness = to_.roughness_map ? 1.0F : fraction("roughness", 0.5);
    to_.material.metalness = to_.metalness_map ? 1.0F : fraction("metalness", 0.5);
  }

  void readSpecular() {
    to_.roughness_map = picture("glossiness_map", PictureContent::kInvertedRed);
    to_.material.roughness = to_.roughness_map ? 1.0F : 1.0F - fraction("glossiness", 0.0);
    to_.material.metalness = 0.0F;
  }

  void readNormalMap() {
    const std::string space = pbr_.child("normal_map").attribute("type");
    if (space == "object") {
      reading_.findings.addNote(
          "normal maps in object space are not drawn; those in tangent space are");
      return;
    }
    to_.normal_map = picture("normal_map", PictureContent::kColour);
  }

  void noteTheRest() const {
    std::string left_out;
    for (const char* name :
         {"ambient_occlusion_map", "environment_map", "specular_map", "light_map"}) {
      if (!readText(pbr_, name).empty())
        left_out += (left_out.empty() ? "" : ", ") + std::string(name);
    }
    if (left_out.empty()) return;
    reading_.findings.addNote("these kinds of material maps are not drawn: " + left_out);
  }

  const Element& material_;
  const Element& pbr_;
  const SourceLocation& location_;
  SdfReading& reading_;
  MaterialSource& to_;
};

/// Overwrites `to` with the numbers and maps of a material's PBR workflow, the metal one if there
/// are both.
/// @param material  a `<material>`
/// @param location  the visual's
/// @return whether the material has a workflow
bool readPbr(const Element& material, const SourceLocation& location, SdfReading& reading,
             MaterialSource& to) {
  const Element pbr = material.child("pbr");
  const Element metal = pbr.child("metal");
  const Element workflow = metal ? metal : pbr.child("specular");
  if (!workflow) return false;
  PbrReader(material, workflow, location, reading, to).read();
  return true;
}

/// SDF 1.0 writes <material script="Gazebo/Grey">.
ScriptRequest requestOf(const Element& material) {
  const Element script = material.child("script");
  ScriptRequest request;
  request.folder = material.folder();
  request.name = script ? readText(script, "name") : material.attribute("script");
  for (const Element& uri : script.children("uri")) {
    const std::string text = uri.text();
    if (!text.empty() && text != "__default__") request.uris.push_back(text);
  }
  return request;
}

/// Whether a material may be unavailable just because a file is missing. Gazebo's own scripts do
/// not count: they are only there if Gazebo is installed.
bool lacksFile(const ScriptRequest& request, const SdfReading& reading) {
  const std::vector<std::string> missing = reading.meshes.scripts().missingUris(request);
  return std::any_of(missing.begin(), missing.end(), [](const std::string& uri) {
    return !startsWith(uri, "file://media/") && !startsWith(uri, "media/");
  });
}

/// Finds a material: a script of the user's own takes precedence over what Gazebo ships under the
/// same name, and this over the other scripts in its media folders.
std::optional<Material> find(const ScriptRequest& request, const SourceLocation& location,
                             SdfReading& reading) {
  const auto missing = [&](const std::string& message) {
    reading.missing(location, "material '" + request.name + "': " + message);
  };
  try {
    std::optional<OgreMaterial> found = reading.meshes.scripts().find(request);
    if (!found) {
      if (auto own = gazeboMaterial(request.name, reading.meshes.textures())) return own;
      found = reading.meshes.scripts().findInMedia(request);
    }
    if (found) {
      for (const std::string& note : found->notes) {
        reading.findings.addNote("material '" + request.name + "': " + note);
      }
      if (reading.survey != nullptr) {
        reading.survey->addPicturesOf(found->source);
        return found->source.material;
      }
      return withPictures(found->source, reading.meshes.textures(), missing);
    }
  } catch (const Error& error) {
    missing(error.what());
    return defaultMaterial();
  }
  return std::nullopt;
}

/// The material that a <material>'s <script> names, from a script or from those that Gazebo ships;
/// the default material if it cannot be found or read (reported).
/// @return nothing if there is no <script>, or if its material is unknown, it names no <uri>, and
///     the <material> has a diffuse colour
std::optional<Material> readSdfScript(const Element& material, const SourceLocation& location,
                                      SdfReading& reading) {
  const ScriptRequest request = requestOf(material);
  if (request.name.empty()) return std::nullopt;
  if (std::optional<Material> found = find(request, location, reading)) return found;
  // Worlds saved by Gazebo name materials that only it knew, and give their colours as well.
  if (request.uris.empty() && material.has("diffuse")) return std::nullopt;
  const std::string thing = "material '" + request.name + "' is in no script (" +
                            reading.meshes.scripts().searchedPlaces(request) +
                            "), and Gazebo ships none of that name" +
                            nearGazeboMaterial(request.name);
  if (lacksFile(request, reading)) {
    reading.missing(location, thing);
  } else {
    reading.findings.addNote(location, thing + "; the default material is drawn");
  }
  return defaultMaterial();
}

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

/// Reads the exponent of the highlight, which has no colour if none is given (SDF specification,
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

/// Adds the pictures that the source names to those that its material has from a script.
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

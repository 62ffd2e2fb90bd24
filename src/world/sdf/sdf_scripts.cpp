#include "world/sdf/sdf_scripts.h"

#include <algorithm>
#include <string>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/files/text.h"
#include "world/material/gazebo_materials.h"
#include "world/material/material_scripts.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

/// SDF 1.0 says <material script="Gazebo/Grey">.
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

/// Whether the file of a material that is not to be had may just be absent; Gazebo's own are where
/// Gazebo is installed.
bool lacksFile(const ScriptRequest& request, const SdfReading& reading) {
  const std::vector<std::string> missing = reading.meshes.scripts().missingUris(request);
  return std::any_of(missing.begin(), missing.end(), [](const std::string& uri) {
    return !startsWith(uri, "file://media/") && !startsWith(uri, "media/");
  });
}

/// A script of the user's own comes before what Gazebo has under the same name, and this before
/// what else is in its media folders.
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

}  // namespace

std::optional<Material> readSdfScript(const Element& material, const SourceLocation& location,
                                      SdfReading& reading) {
  const ScriptRequest request = requestOf(material);
  if (request.name.empty()) return std::nullopt;
  if (std::optional<Material> found = find(request, location, reading)) return found;
  // Worlds that Gazebo has saved name materials that only it knew, and say their colours as well.
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

}  // namespace synthetic_dataset::world

#include "world/sdf/sdf_scripts.h"

#include <string>

#include "synthetic_dataset/errors.h"
#include "world/material/gazebo_materials.h"
#include "world/material/material_scripts.h"
#include "world/sdf/sdf_materials.h"

namespace synthetic_dataset::world {
namespace {

/// What SDF has where a file says nothing, and what Gazebo saves for materials of its own making.
constexpr const char* kDefault = "__default__";

ScriptRequest requestOf(const sdf::ElementPtr& script, SdfReading& reading) {
  ScriptRequest request;
  request.folder = reading.folderOf(script);
  if (has(script, "name")) request.name = script->GetElement("name")->Get<std::string>();
  if (!has(script, "uri")) return request;
  for (sdf::ElementPtr uri = script->GetElement("uri"); uri; uri = uri->GetNextElement("uri")) {
    const auto text = uri->Get<std::string>();
    if (!text.empty() && text != kDefault) request.uris.push_back(text);
  }
  return request;
}

/// A script of the user's own comes before what Gazebo has under the same name.
std::optional<Material> find(const ScriptRequest& request, const Place& place,
                             SdfReading& reading) {
  const auto missing = [&](const std::string& message) {
    reading.missing(place.message("material '" + request.name + "': " + message));
  };
  try {
    if (const std::optional<OgreMaterial> found = reading.meshes.scripts().find(request)) {
      for (const std::string& note : found->notes) {
        reading.findings.addNote("material '" + request.name + "': " + note);
      }
      return withPictures(found->source, reading.meshes.textures(), missing);
    }
  } catch (const Error& error) {
    missing(error.what());
    return defaultMaterial();
  }
  return gazeboMaterial(request.name, reading.meshes.textures());
}

}  // namespace

std::optional<Material> readSdfScript(const sdf::ElementPtr& material, const Place& place,
                                      SdfReading& reading) {
  const sdf::ElementPtr script = descendant(material, {"script"});
  if (!script) return std::nullopt;
  const ScriptRequest request = requestOf(script, reading);
  if (request.name.empty() || request.name == kDefault) return std::nullopt;
  if (std::optional<Material> found = find(request, place, reading)) return found;
  // Worlds that Gazebo has saved name materials that only it knew, and say their colours as well.
  if (request.uris.empty() && has(material, "diffuse")) return std::nullopt;
  reading.missing(place.message("material '" + request.name + "' is in no script (" +
                                reading.meshes.scripts().searchedPlaces(request) +
                                "), and Gazebo ships none of that name" +
                                nearGazeboMaterial(request.name)));
  return defaultMaterial();
}

}  // namespace synthetic_dataset::world

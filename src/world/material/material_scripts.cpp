#include "world/material/material_scripts.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/input_file.h"
#include "synthetic_dataset/errors.h"
#include "world/material/ogre_inheritance.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

void addOnce(std::vector<fs::path>& paths, const fs::path& path) {
  if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
}

/// Sorted by name, as a folder's entries come in any order.
std::vector<fs::path> scriptsIn(const fs::path& folder) {
  std::vector<fs::path> scripts;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".material" && isFile(entry->path())) {
      scripts.push_back(entry->path());
    }
  }
  std::sort(scripts.begin(), scripts.end());
  return scripts;
}

/// Completes a reference, whose URI is as in the script, with the folders in which to look for the
/// picture.
void place(std::optional<TextureReference>& reference, const fs::path& script,
           const std::vector<fs::path>& folders) {
  if (!reference) return;
  reference->folder = script.parent_path();
  reference->more_folders = folders;
}

}  // namespace

MaterialScripts::Places MaterialScripts::placesOf(const ScriptRequest& request) const {
  Places places;
  for (const std::string& uri : request.uris) {
    const std::optional<fs::path> found = finder_.find(uri, request.folder);
    if (!found) {
      places.missing.push_back(uri);
    } else if (isFolder(*found)) {
      for (const fs::path& folder : {*found, *found / "materials/scripts"}) {
        for (const fs::path& script : scriptsIn(folder)) addOnce(places.scripts, script);
      }
      addOnce(places.folders, *found);
      addOnce(places.folders, *found / "materials/textures");
    } else {
      addOnce(places.scripts, *found);
    }
  }
  for (const fs::path& script : places.scripts) {
    addOnce(places.folders, (script.parent_path() / "../textures").lexically_normal());
    addOnce(places.folders, script.parent_path());
  }
  addOnce(places.folders, request.folder / "materials/textures");
  return places;
}

const OgreScript& MaterialScripts::read(const fs::path& file) {
  auto found = scripts_.find(file.string());
  if (found == scripts_.end()) {
    std::variant<OgreScript, std::string> content;
    try {
      content = parseOgreScript(base::readInput(file));
    } catch (const Error& error) {
      content = file.string() + ": " + error.what();
    }
    found = scripts_.emplace(file.string(), std::move(content)).first;
  }
  if (const auto* reason = std::get_if<std::string>(&found->second)) throw Error(*reason);
  return std::get<OgreScript>(found->second);
}

/// Collects a script's own sections, then those that it imports. An import that cannot be found
/// only matters when something inherits from it.
void MaterialScripts::gatherFrom(const fs::path& file, const Paths& folders, Paths& seen,
                                 std::vector<Entry>& entries) {
  if (std::find(seen.begin(), seen.end(), file) != seen.end()) return;
  seen.push_back(file);
  const OgreScript& script = read(file);
  for (const OgreObject& object : script.objects) entries.push_back({&object, file});
  for (const std::string& import : script.imports) {
    Paths candidates{file.parent_path() / import};
    for (const fs::path& folder : folders) candidates.push_back(folder / import);
    const auto found = std::find_if(candidates.begin(), candidates.end(), isFile);
    if (found != candidates.end()) {
      gatherFrom(found->lexically_normal(), folders, seen, entries);
    }
  }
}

std::vector<MaterialScripts::Entry> MaterialScripts::gather(const Places& places) {
  std::vector<Entry> entries;
  Paths seen;
  for (const fs::path& script : places.scripts) gatherFrom(script, places.folders, seen, entries);
  return entries;
}

std::optional<OgreMaterial> MaterialScripts::find(const ScriptRequest& request) {
  const Places places = placesOf(request);
  const std::vector<Entry> entries = gather(places);
  const auto entryOf = [&](const std::string& kind, const std::string& name) {
    return std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
      return entry.object->kind == kind && entry.object->name == name;
    });
  };
  const auto found = entryOf("material", request.name);
  if (found == entries.end()) return std::nullopt;
  const auto look_up = [&](const std::string& kind, const std::string& name) {
    const auto entry = entryOf(kind, name);
    return entry == entries.end() ? nullptr : entry->object;
  };
  try {
    OgreObject object = withInherited(*found->object, look_up);
    replaceVariables(object);
    OgreMaterial material = readOgreMaterial(object);
    for (MaterialSource* source = &material.source; source; source = source->overlay.get()) {
      place(source->texture, found->file, places.folders);
      place(source->factor, found->file, places.folders);
      place(source->normal_map, found->file, places.folders);
    }
    return material;
  } catch (const Error& error) {
    throw Error(found->file.string() + ": " + error.what());
  }
}

std::optional<OgreMaterial> MaterialScripts::findInMedia(const ScriptRequest& request) {
  for (const std::string& folder : finder_.mediaFolders()) {
    for (const char* media : {"media", "Media"}) {
      const fs::path materials = fs::path(folder) / media / "materials";
      for (const fs::path& script : scriptsIn(materials / "scripts")) {
        try {
          const ScriptRequest in_script{request.name, {script.string()}, request.folder};
          if (auto found = find(in_script)) return found;
        } catch (const Error&) {
          continue;  // a script that cannot be read, but that nobody has named
        }
      }
    }
  }
  return std::nullopt;
}

std::string MaterialScripts::searchedPlaces(const ScriptRequest& request) const {
  const Places places = placesOf(request);
  std::string text;
  const auto add = [&](const std::string& place) { text += (text.empty() ? "" : ", ") + place; };
  for (const fs::path& script : places.scripts) add(script.string());
  for (const std::string& uri : places.missing) {
    add("'" + uri + "' (not there; " + finder_.searchedPlaces(uri, request.folder) + ")");
  }
  return text.empty() ? "no <uri> names a script or a folder with scripts" : "looked in " + text;
}

}  // namespace synthetic_dataset::world

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "world/files/resource_finder.h"
#include "world/material/ogre_material.h"
#include "world/material/ogre_script.h"

namespace synthetic_dataset::world {

/// A material as an SDF file refers to it: `<script><uri>...</uri><name>...</name></script>`.
struct ScriptRequest {
  std::string name;
  std::vector<std::string> uris;  ///< of scripts, and of folders with scripts or with pictures
  std::filesystem::path folder;   ///< of the file with the reference
};

/// Finds materials in OGRE scripts; reads each script once.
class MaterialScripts {
 public:
  explicit MaterialScripts(const ResourceFinder& finder) : finder_(finder) {}
  explicit MaterialScripts(ResourceFinder&&) = delete;  // it has to outlive this

  /// Searches the scripts and folders that the URIs name, which may be in Gazebo's media, and
  /// `materials/scripts` below those folders. Pictures are looked for next to the scripts, in
  /// `textures` next to their folder, in all folders named, in the model's materials/textures and
  /// in Gazebo's media.
  /// @return nothing if no script has a material of this name
  /// @throws Error about the script that has it, or about one that may have it but cannot be read:
  ///     "shelf.material: line 7: ..."
  [[nodiscard]] std::optional<OgreMaterial> find(const ScriptRequest& request);

  /// The same in the `media/materials/scripts` of all of Gazebo's media folders; Gazebo Classic
  /// finds the materials there by their names alone (RenderEngine.cc, SetupResources).
  [[nodiscard]] std::optional<OgreMaterial> findInMedia(const ScriptRequest& request);

  /// The URIs for which nothing is found.
  [[nodiscard]] std::vector<std::string> missingUris(const ScriptRequest& request) const {
    return placesOf(request).missing;
  }

  /// Where `find` looks, for messages: "looked in a, b".
  [[nodiscard]] std::string searchedPlaces(const ScriptRequest& request) const;

 private:
  using Paths = std::vector<std::filesystem::path>;

  /// A section and the script that contains it.
  struct Entry {
    const OgreObject* object = nullptr;
    std::filesystem::path file;
  };

  struct Places {
    Paths scripts;
    Paths folders;
    std::vector<std::string> missing;  ///< URIs for which nothing is found
  };

  [[nodiscard]] Places placesOf(const ScriptRequest& request) const;
  [[nodiscard]] const OgreScript& read(const std::filesystem::path& file);
  [[nodiscard]] std::vector<Entry> gather(const Places& places);
  void gatherFrom(const std::filesystem::path& file, const Paths& folders, Paths& seen,
                  std::vector<Entry>& entries);

  const ResourceFinder& finder_;
  std::map<std::string, std::variant<OgreScript, std::string>> scripts_;  ///< or its error message
};

}  // namespace synthetic_dataset::world

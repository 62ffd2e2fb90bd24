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

/// Where an SDF file says that a material is: `<script><uri>...</uri><name>...</name></script>`.
struct ScriptRequest {
  std::string name;
  std::vector<std::string> uris;  ///< of scripts, and of folders with scripts or with pictures
  std::filesystem::path folder;   ///< of the file that says so
};

/// Finds materials in OGRE's scripts; reads each script once.
class MaterialScripts {
 public:
  explicit MaterialScripts(const ResourceFinder& finder) : finder_(finder) {}
  explicit MaterialScripts(ResourceFinder&&) = delete;  // it has to outlive this

  /// Looks into the scripts and folders that the URIs name, into `materials/scripts` below those
  /// folders, and for URIs that lead nowhere into Gazebo's media. Pictures are looked for beside
  /// the scripts, in `textures` beside their folder, in all folders named, in the model's
  /// materials/textures and in Gazebo's media.
  /// @return nothing where no script has the name
  /// @throws Error of the script that has it, or of one that may have it but cannot be read:
  ///     "shelf.material: line 7: ..."
  [[nodiscard]] std::optional<OgreMaterial> find(const ScriptRequest& request);

  /// The same in the `media/materials/scripts` of all of Gazebo's media folders, whose materials
  /// Gazebo Classic knows by their names alone (RenderEngine.cc, SetupResources).
  [[nodiscard]] std::optional<OgreMaterial> findInMedia(const ScriptRequest& request);

  /// The URIs that lead nowhere.
  [[nodiscard]] std::vector<std::string> missingUris(const ScriptRequest& request) const {
    return placesOf(request).missing;
  }

  /// Where `find` looks, for messages: "looked in a, b".
  [[nodiscard]] std::string searchedPlaces(const ScriptRequest& request) const;

 private:
  using Paths = std::vector<std::filesystem::path>;

  /// A section and the script that has it.
  struct Entry {
    const OgreObject* object = nullptr;
    std::filesystem::path file;
  };

  struct Places {
    Paths scripts;
    Paths folders;
    std::vector<std::string> missing;  ///< URIs that lead nowhere
  };

  [[nodiscard]] Places placesOf(const ScriptRequest& request) const;
  [[nodiscard]] const OgreScript& read(const std::filesystem::path& file);
  [[nodiscard]] std::vector<Entry> gather(const Places& places);
  void gatherFrom(const std::filesystem::path& file, const Paths& folders, Paths& seen,
                  std::vector<Entry>& entries);

  const ResourceFinder& finder_;
  std::map<std::string, std::variant<OgreScript, std::string>> scripts_;  ///< or what is wrong
};

}  // namespace synthetic_dataset::world

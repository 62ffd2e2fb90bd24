#pragma once

/// Worlds made by others, found as in their users' environment.

#include <filesystem>
#include <string>
#include <vector>

#include "world/description.h"
#include "world/files/resource_finder.h"

namespace synthetic_dataset::test {

/// A world file, or a model of Gazebo's library, and what Gazebo 11 made of it.
struct ReferenceWorld {
  std::string name;                 ///< "repository/world", "models/model"
  std::string uri;                  ///< of the world file or the model
  std::filesystem::path reference;  ///< the folder with state.json and pictures
  std::filesystem::path root;       ///< of the repository
};

/// All of the reference folder's, sorted by name.
[[nodiscard]] std::vector<ReferenceWorld> referenceWorlds();

/// The finder of a repository's files: each folder that holds models or packages.
[[nodiscard]] world::ResourceFinder finderFor(const std::filesystem::path& root);

/// Loads a world without its missing parts.
[[nodiscard]] world::Description loadReferenceWorld(const ReferenceWorld& world);

}  // namespace synthetic_dataset::test

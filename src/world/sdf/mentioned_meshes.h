#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}

namespace synthetic_dataset::world {

/// A mesh file that an SDF file names.
struct MentionedMesh {
  std::string uri;
  std::filesystem::path folder;  ///< of the SDF file
  bool shows_pictures = false;   ///< a visual leaves the look to the mesh's own materials
};

/// Those of an element and all below it, before libsdformat reads it.
/// @param folder  of the file
[[nodiscard]] std::vector<MentionedMesh> mentionedMeshes(const tinyxml2::XMLElement& element,
                                                         const std::filesystem::path& folder);

}  // namespace synthetic_dataset::world

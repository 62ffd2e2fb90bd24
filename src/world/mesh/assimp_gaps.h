#pragma once

#include <filesystem>

#include "world/mesh/mesh_file.h"

namespace synthetic_dataset::world {

/// Whether assimp is older than 5.1, as those of Debian 11 and Ubuntu 20.04 are: it does not read
/// the texture transforms of glTF, and has wrong colours of binary STL files.
[[nodiscard]] bool assimpHasGaps();

/// Where it has, removes what it has wrong from what was read of a file, and notes what is lacking.
void fillAssimpGaps(const std::filesystem::path& file, MeshFile& content);

}  // namespace synthetic_dataset::world

#pragma once

#include <filesystem>

#include "world/mesh/mesh_file.h"

namespace synthetic_dataset::world {

/// Whether assimp is older than 5.1, as on Debian 11 and Ubuntu 20.04: such versions do not read
/// the texture transforms of glTF, and read wrong colours from binary STL files.
[[nodiscard]] bool assimpHasGaps();

/// If assimpHasGaps(), removes the wrong data from what was read from a file, and notes what is
/// missing.
void removeUnreliableData(const std::filesystem::path& file, MeshFile& content);

}  // namespace synthetic_dataset::world

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "world/mesh/mesh_file.h"

namespace synthetic_dataset::world {

/// Reads many mesh files at once, as many side by side as the machine has cores. Processes of their
/// own cost more than the reading of a small file does; here some files share one.
/// @return those that could be read, by path; of the others readMeshFile says what is wrong
[[nodiscard]] std::map<std::string, MeshFile> readMeshFiles(
    const std::vector<std::filesystem::path>& files);

}  // namespace synthetic_dataset::world

#pragma once

#include <string>
#include <string_view>

#include "world/mesh/mesh_file.h"

namespace synthetic_dataset::world {

/// Serializes a mesh file's content, to pass it from one process of this program to another.
[[nodiscard]] std::string toBytes(const MeshFile& file);

/// @throws Error if the bytes are incomplete
[[nodiscard]] MeshFile meshFileOf(std::string_view bytes);

}  // namespace synthetic_dataset::world

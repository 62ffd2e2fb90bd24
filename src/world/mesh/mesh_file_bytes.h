#pragma once

#include <string>
#include <string_view>

#include "world/mesh/mesh_file.h"

namespace synthetic_dataset::world {

/// A mesh file's content as bytes, to hand it from one process of this program to another.
[[nodiscard]] std::string toBytes(const MeshFile& file);

/// @throws Error if the bytes are not whole
[[nodiscard]] MeshFile meshFileOf(std::string_view bytes);

}  // namespace synthetic_dataset::world

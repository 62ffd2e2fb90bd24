#pragma once

#include <filesystem>
#include <string>

#include "world/material/material_source.h"
#include "world/mesh/mesh_pictures.h"

namespace synthetic_dataset::world {

/// The extension in lower case, with its dot.
[[nodiscard]] std::string extensionOf(const std::filesystem::path& file);

/// Reads a material of a mesh file.
/// @param pictures  of the scene that the material belongs to
[[nodiscard]] MaterialSource readMaterial(const aiMaterial& material,
                                          const std::filesystem::path& file,
                                          MeshPictures& pictures);

/// Whether the material is one that assimp makes for files without materials.
[[nodiscard]] bool isDefaultMaterial(const aiMaterial& material, const std::filesystem::path& file);

/// The index of the texture coordinates that the diffuse picture uses.
[[nodiscard]] unsigned textureChannel(const aiMaterial& material);

}  // namespace synthetic_dataset::world

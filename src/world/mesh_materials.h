#pragma once

#include <filesystem>
#include <string>

#include "world/mesh_file.h"

struct aiMaterial;
struct aiScene;

namespace synthetic_dataset::world {

/// In lower case, with its dot.
[[nodiscard]] std::string extensionOf(const std::filesystem::path& file);

/// A material of a mesh file: colours, opacity, and where its diffuse picture is.
[[nodiscard]] MeshMaterial readMaterial(const aiScene& scene, const aiMaterial& material,
                                        const std::filesystem::path& file);

/// The set of texture coordinates that the diffuse picture uses.
[[nodiscard]] unsigned textureChannel(const aiMaterial& material);

}  // namespace synthetic_dataset::world

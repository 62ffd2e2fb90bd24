#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "world/description.h"
#include "world/texture_loader.h"

namespace synthetic_dataset::world {

/// A material as a mesh file gives it, its picture not yet read.
struct MeshMaterial {
  Material material;
  std::optional<TextureReference> texture;
};

/// A piece of a mesh file in one material, in the file's frame and in metres.
struct MeshPart {
  std::vector<std::string> names;  ///< by which <submesh> may call it: of its node, of its geometry
  Mesh mesh;
  std::size_t material = 0;  ///< index into MeshFile::materials
};

struct MeshFile {
  std::vector<MeshPart> parts;  ///< in the order of the file's scene; at least one triangle in all
  std::vector<MeshMaterial> materials;
};

/// Reads a mesh of any format that assimp knows (COLLADA, OBJ, STL, glTF, ...), as Gazebo does:
/// COLLADA's unit is applied; its `up_axis` is not, and no other format is turned either.
/// Normals are made where there are none, creased at sharp edges.
/// @throws Error if the file cannot be read, has no triangle or a vertex that is no number
[[nodiscard]] MeshFile readMeshFile(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world

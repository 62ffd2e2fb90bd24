#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/sandbox/sandboxed_process.h"
#include "world/description.h"
#include "world/material/material_source.h"

namespace synthetic_dataset::world {

/// A piece of a mesh file in one material, in the file's frame and in metres.
struct MeshPart {
  std::vector<std::string> names;  ///< by which <submesh> may call it: of its node, of its geometry
  Mesh mesh;
  std::size_t material = 0;  ///< index into MeshFile::materials
};

struct MeshFile {
  std::vector<MeshPart> parts;  ///< in the order of the file's scene; at least one triangle in all
  std::vector<MaterialSource> materials;
  std::vector<std::string> notes;  ///< what is drawn otherwise than the file would have it
  std::vector<std::filesystem::path> files;  ///< that it was read of, or that are not there
  bool has_lines = false;                    ///< which have no area, and are in no part
  bool y_up = false;  ///< its COLLADA says that y points up, which is not heeded
  std::string
      refusal;  ///< what it names and may not ("names the file ..."); then all else is empty
};

/// Reads a mesh of any format that assimp knows (COLLADA, OBJ, STL, glTF, ...), as Gazebo does:
/// COLLADA's unit is applied; its `up_axis` is not, and no other format is turned either.
/// Normals are made where there are none, creased at sharp edges. Of binary STL files the colours
/// of VisCAM and of Materialise Magics are read as assimp understands them.
/// The work is done in a process of its own: files that are damaged, or made to do damage, crash
/// assimp (5.2) or have it eat up the memory.
/// @param animation  a file whose first animation a skin begins; without one, skins are as modelled
/// @throws Error if the file cannot be read, has no triangle or a vertex that is no number
[[nodiscard]] MeshFile readMeshFile(
    const std::filesystem::path& file,
    const std::optional<std::filesystem::path>& animation = std::nullopt);

/// readMeshFile in this process, which it may bring down.
[[nodiscard]] MeshFile importMeshFile(
    const std::filesystem::path& file,
    const std::optional<std::filesystem::path>& animation = std::nullopt);

/// Long enough for any real file of this size, and an end soon for one that assimp hangs on.
[[nodiscard]] base::SandboxLimits meshSandboxLimits(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world

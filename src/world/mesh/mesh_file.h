#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/sandbox/sandboxed_process.h"
#include "world/description.h"
#include "world/material/material_source.h"

namespace synthetic_dataset::world {

/// A part of a mesh file with a single material, in the file's frame and in metres.
struct MeshPart {
  std::vector<std::string> names;  ///< for <submesh> to refer to: its node's and its geometry's
  Mesh mesh;
  std::size_t material = 0;  ///< index into MeshFile::materials
};

struct MeshFile {
  std::vector<MeshPart> parts;  ///< in the order of the file's scene; at least one triangle in all
  std::vector<MaterialSource> materials;
  std::vector<std::string> notes;            ///< what is drawn differently from the file
  std::vector<std::filesystem::path> files;  ///< that it was read from, or that are missing
  bool has_lines = false;                    ///< which have no area, and are in no part
  bool y_up = false;    ///< its COLLADA declares that y points up, which is ignored
  std::string refusal;  ///< why the file is refused ("names the file ..."); then all else is empty
};

/// Reads a mesh of any format that assimp supports (COLLADA, OBJ, STL, glTF, ...), as Gazebo does:
/// COLLADA's unit is applied; its `up_axis` is not, and no other format is rotated either. Missing
/// normals are generated, with creases at sharp edges. Colours in binary STL files, as written by
/// VisCAM and Materialise Magics, are read as assimp understands them. The work is done in a
/// separate process: damaged or malicious files crash assimp (5.2) or make it use up all memory.
/// @param animation  a file whose first animation gives the skin its initial pose; without one,
///     skins are as modelled
/// @throws Error if the file cannot be read, has no triangle or a vertex that is not a number
[[nodiscard]] MeshFile readMeshFile(
    const std::filesystem::path& file,
    const std::optional<std::filesystem::path>& animation = std::nullopt);

/// Like readMeshFile, but in this process, which it may bring down.
[[nodiscard]] MeshFile importMeshFile(
    const std::filesystem::path& file,
    const std::optional<std::filesystem::path>& animation = std::nullopt);

/// Limits that are generous for any real file of this size, but soon end the reading of one on
/// which assimp hangs.
[[nodiscard]] base::SandboxLimits meshSandboxLimits(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world

#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// Rewrites an OBJ file's text so that assimp reads it correctly: assimp (5.2) silently drops lines
/// with numbers such as `.4`, takes blanks at the end of a line, and a byte order mark at the start
/// of the text, for parts of names, and takes several material libraries on a line for one. It
/// would also drop faces whose corners refer to texture coordinates or normals that the file does
/// not have.
[[nodiscard]] std::string repairedObj(const std::string& text);

/// The same for a material library.
[[nodiscard]] std::string repairedMtl(const std::string& text);

/// The material libraries that an OBJ file names.
[[nodiscard]] std::vector<std::string> librariesOfObj(const std::string& text);

/// The names of the materials that a library defines.
[[nodiscard]] std::vector<std::string> materialsOfMtl(const std::string& text);

}  // namespace synthetic_dataset::world

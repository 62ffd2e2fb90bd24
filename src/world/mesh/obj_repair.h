#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// An OBJ file's text as assimp reads it rightly: assimp (5.2) drops lines with numbers such as
/// `.4` without a word, and takes blanks at the end of a line, and a byte order mark at the text's
/// begin, for parts of names; and it takes several material libraries on a line for one. A face
/// whose corners name texture coordinates or normals of a file that has none would be dropped as
/// well.
[[nodiscard]] std::string repairedObj(const std::string& text);

/// The same of a material library.
[[nodiscard]] std::string repairedMtl(const std::string& text);

/// The material libraries that an OBJ file names.
[[nodiscard]] std::vector<std::string> librariesOfObj(const std::string& text);

/// The names of the materials that a library defines.
[[nodiscard]] std::vector<std::string> materialsOfMtl(const std::string& text);

}  // namespace synthetic_dataset::world

#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace synthetic_dataset::world {

/// Arguments of a xacro file, by their names: `prefix` is given as `prefix:=left_`.
using XacroArguments = std::map<std::string, std::string>;

/// Whether a file is one that xacro has to expand.
[[nodiscard]] bool isXacro(const std::filesystem::path& file);

/// The text that xacro makes of a file: the program `xacro` of PATH, else the Python module. It
/// runs in a sandboxed process.
/// @throws Error if there is no xacro, with how to get it and what to run; or with what xacro says
[[nodiscard]] std::string expandXacro(const std::filesystem::path& file,
                                      const XacroArguments& arguments);

}  // namespace synthetic_dataset::world

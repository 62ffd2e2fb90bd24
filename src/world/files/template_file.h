#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace synthetic_dataset::world {

/// Arguments of a template, by their names: `prefix` is given to xacro as `prefix:=left_`.
using TemplateArguments = std::map<std::string, std::string>;

/// Whether a file is one that has to be expanded: xacro's, or Jinja's (`.jinja`, `.j2`), as PX4 has
/// worlds and models. ERB's are not, as they may run any program.
[[nodiscard]] bool isTemplate(const std::filesystem::path& file);

/// The text that is made of a template, in a sandboxed process: by the program `xacro` of PATH,
/// else by its Python module; by Jinja in its own sandbox.
/// @throws Error if there is no xacro or no Jinja, with how to get it; or with what it says
[[nodiscard]] std::string expandTemplate(const std::filesystem::path& file,
                                         const TemplateArguments& arguments);

}  // namespace synthetic_dataset::world

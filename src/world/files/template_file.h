#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace synthetic_dataset::world {

/// The arguments of a template, by name: `prefix` is passed to xacro as `prefix:=left_`.
using TemplateArguments = std::map<std::string, std::string>;

/// Whether a file is a template that has to be expanded: xacro, or Jinja (`.jinja`, `.j2`), in
/// which PX4 has worlds and models. ERB templates do not count, as they may run any program.
[[nodiscard]] bool isTemplate(const std::filesystem::path& file);

/// Expands a template in a sandboxed process: with the program `xacro` on PATH, else with its
/// Python module; or with Jinja, in Jinja's own sandbox.
/// @throws Error if there is no xacro or no Jinja, with how to get it; or with its error message
[[nodiscard]] std::string expandTemplate(const std::filesystem::path& file,
                                         const TemplateArguments& arguments);

}  // namespace synthetic_dataset::world

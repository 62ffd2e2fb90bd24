#pragma once

#include <functional>
#include <optional>
#include <string>

namespace synthetic_dataset::config {

/// Looks up a name: an environment variable, or the folder of a package.
using TextFinder = std::function<std::optional<std::string>(const std::string& name)>;

/// Looks up a variable in the environment of this process.
[[nodiscard]] std::optional<std::string> environmentVariable(const std::string& name);

/// The sources of substituted values.
struct SubstitutionSources {
  std::string file;  ///< for messages; its folder is `$(dirname)`
  TextFinder package_folder;
  TextFinder environment = environmentVariable;
};

/// Replaces `$(find PKG)`, `$(env NAME)`, `$(optenv NAME [default words])` and `$(dirname)` in a
/// settings file's text, as roslaunch does for `<rosparam subst_value="true">`: in the raw text,
/// including comments, before it is read as YAML; nothing can be escaped; environment variables may
/// contain `$(find PKG)`; a substitution without `)` is left unchanged.
///
/// Unlike in roslaunch, `$(dirname)` is the folder of this file, not of a launch file, and files in
/// the package's build space are not searched for: `$(find PKG)` is always the package's folder.
/// @throws Error "<file>: line 3: ..." for what is not known, including `$(arg x)`, `$(anon x)` and
///     `$(eval ...)`
[[nodiscard]] std::string substitute(const std::string& text, const SubstitutionSources& sources);

}  // namespace synthetic_dataset::config

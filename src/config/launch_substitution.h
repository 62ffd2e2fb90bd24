#pragma once

#include <functional>
#include <optional>
#include <string>

namespace synthetic_dataset::config {

/// Looks a name up: an environment variable, the folder of a package.
using TextFinder = std::function<std::optional<std::string>(const std::string& name)>;

/// The environment of this process.
[[nodiscard]] std::optional<std::string> environmentVariable(const std::string& name);

/// What substitutions are made from.
struct SubstitutionSources {
  std::string file;  ///< for messages; its folder is `$(dirname)`
  TextFinder package_folder;
  TextFinder environment = environmentVariable;
};

/// Replaces `$(find PKG)`, `$(env NAME)`, `$(optenv NAME [default words])` and `$(dirname)` in a
/// settings file's text, as roslaunch does for `<rosparam subst_value="true">`: in the text as it
/// stands, comments included, before it is read as YAML; nothing can be escaped; values of the
/// environment may hold `$(find PKG)`; what never closes stays as it is.
///
/// Unlike roslaunch, `$(dirname)` is the folder of this file, not of a launch file, and a file that
/// only the package's build has is not looked for: `$(find PKG)` is the package's folder.
/// @throws Error "<file>: line 3: ..." for what is not known, `$(arg x)`, `$(anon x)` and
///     `$(eval ...)` included
[[nodiscard]] std::string substitute(const std::string& text, const SubstitutionSources& sources);

}  // namespace synthetic_dataset::config

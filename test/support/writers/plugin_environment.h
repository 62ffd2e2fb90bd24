#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::test {

/// Sets this process's environment as a sourced workspace does, so that pluginlib finds this
/// package's plugins and those of the tests.
/// @param packages  folders of more packages with plugins
void preparePluginEnvironment(const std::vector<std::string>& packages = {});

/// The plugin description of this package, the one that users have.
[[nodiscard]] std::string pluginXml();

/// The plugin description of the example package with a writer (examples/box_table_writer).
[[nodiscard]] std::string examplePluginXml();

/// The plugin description of the tests' misbehaving writers.
[[nodiscard]] std::string testPluginXml();

}  // namespace synthetic_dataset::test

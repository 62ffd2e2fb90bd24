#pragma once

#include <string>

#include "base/yaml_text/yaml_change.h"

namespace synthetic_dataset::programs {

/// Removes from a settings file the remark ("# TODO: ...") by which `start` marks a setting that is
/// still to be chosen: at the end of the setting's line, or as a line of its group in which the
/// setting is commented out. Nothing else in the text changes.
/// @param path  of a setting that has been set
[[nodiscard]] std::string withoutGap(const std::string& text, const std::string& origin,
                                     const base::YamlPath& path);

}  // namespace synthetic_dataset::programs

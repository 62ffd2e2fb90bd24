#pragma once

#include <string>

#include "base/yaml_text/yaml_change.h"

namespace synthetic_dataset::programs {

/// A settings file without the remark that a setting is still to be chosen, as `start` leaves it
/// ("# TODO: ..."): at the end of the setting's line, or as a line of its group that has the
/// setting in a comment. Nothing else of the text changes.
/// @param path  of a setting that has been set
[[nodiscard]] std::string withoutGap(const std::string& text, const std::string& origin,
                                     const base::YamlPath& path);

}  // namespace synthetic_dataset::programs

#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// The messages about files that are not there, with what a relative path of the settings starts
/// at, as that is seldom the settings file's folder.
/// @param settings  as the user gave them
[[nodiscard]] std::vector<std::string> explainRelativePaths(std::vector<std::string> messages,
                                                            const Value& settings);

}  // namespace synthetic_dataset::run

#pragma once

#include <string>

#include "programs/setup_assistant/folders/allowed_folders.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The settings that `start` would write for the files that a request names.
/// @param body  `bags`, a list of at least one; `world`, optional; `models`, a list
/// @param allowed  the folders in which these files may lie
/// @throws HttpError 400 or 403; Error if a file cannot be read
[[nodiscard]] std::string startText(const Value& body, const AllowedFolders& allowed);

}  // namespace synthetic_dataset::programs

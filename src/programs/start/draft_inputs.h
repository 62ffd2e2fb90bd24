#pragma once

#include <optional>
#include <string>
#include <vector>

#include "programs/start/settings_draft.h"

namespace synthetic_dataset::programs {

/// An existing file's absolute path; a URI as it is.
/// @throws Error where there is no such file
[[nodiscard]] std::string absoluteFile(const std::string& name);

/// The recording and the world of a draft, read; no objects and no formats.
/// @throws Error where a file is not there or cannot be read
[[nodiscard]] DraftInputs readDraftInputs(const std::vector<std::string>& bag_files,
                                          const std::optional<std::string>& world);

/// An object of a draft with its model, of which the size is measured.
[[nodiscard]] DraftInputs::Object objectOf(const std::string& name, const std::string& model);

/// Objects for models whose names nobody has said: each is the recording's robot that is called
/// most nearly like its file, else the first one that is left, else called like its file.
[[nodiscard]] std::vector<DraftInputs::Object> objectsOf(const std::vector<std::string>& models,
                                                         const motion::BagContents& contents);

}  // namespace synthetic_dataset::programs

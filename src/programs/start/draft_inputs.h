#pragma once

#include <optional>
#include <string>
#include <vector>

#include "programs/start/settings_draft.h"

namespace synthetic_dataset::programs {

/// The absolute path of an existing file; a URI is returned unchanged.
/// @throws Error if there is no such file
[[nodiscard]] std::string absoluteFile(const std::string& name);

/// Reads the recording and the world of a draft; leaves objects and formats empty.
/// @throws Error if a file is missing or cannot be read
[[nodiscard]] DraftInputs readDraftInputs(const std::vector<std::string>& bag_files,
                                          const std::optional<std::string>& world);

/// An object of a draft with its model, whose size is measured.
[[nodiscard]] DraftInputs::Object objectOf(const std::string& name, const std::string& model);

/// Objects for models that were given without names. Each takes the name of the recording's robot
/// that is most similar to its file's name, else of the first robot that is left, else of its file.
[[nodiscard]] std::vector<DraftInputs::Object> objectsOf(const std::vector<std::string>& models,
                                                         const motion::BagContents& contents);

}  // namespace synthetic_dataset::programs

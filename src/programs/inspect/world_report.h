#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synthetic_dataset/value.h"
#include "world/description.h"

namespace synthetic_dataset::programs {

/// The folders around a file in which the models that it names may lie, and are not looked for
/// otherwise: `models` beside it or beside its folder.
[[nodiscard]] std::vector<std::string> modelFoldersAround(const std::filesystem::path& file);

/// A world or model file, without what is missing of it; that is in the notes.
/// @throws ErrorList as world::loadWorld
[[nodiscard]] world::Description readForInspection(const std::filesystem::path& file);

/// What a world or a model has, for the eye: models with sizes and places, links, lights, cameras.
[[nodiscard]] std::string worldText(const world::Description& description);

/// The same for programs. Lengths are numbers [m].
[[nodiscard]] Value worldValue(const world::Description& description);

}  // namespace synthetic_dataset::programs

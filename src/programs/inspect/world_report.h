#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synthetic_dataset/value.h"
#include "world/description.h"

namespace synthetic_dataset::programs {

/// The folders around a file that may contain the models that it names, but are not searched
/// otherwise: `models` beside the file or beside its folder.
[[nodiscard]] std::vector<std::string> modelFoldersAround(const std::filesystem::path& file);

/// Loads a world or model file without the assets that are missing; its notes list these.
/// @throws ErrorList as world::loadWorld
[[nodiscard]] world::Description readForInspection(const std::filesystem::path& file);

/// The contents of a world or a model as text for people: models with sizes and places, links,
/// lights, cameras, lidars.
[[nodiscard]] std::string worldText(const world::Description& description);

/// The same for programs. Lengths are numbers in [m].
[[nodiscard]] Value worldValue(const world::Description& description);

}  // namespace synthetic_dataset::programs

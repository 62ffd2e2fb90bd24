#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::nuscenes {

/// Why the dataset has nuScenes scenes for which there is no name; nothing where it has none.
[[nodiscard]] std::optional<std::string> sceneNameProblem(const DatasetInfo& dataset);

/// What a nuScenes scene is called. Trainers find the scenes of a split by the names that the
/// devkit lists for it: those of `val` and `test` have names of its lists, all others of `train`.
/// @param sequence  of nuScenesSequence
/// @throws Error where there is no name
[[nodiscard]] std::string sceneName(const DatasetInfo& dataset, std::int64_t sequence);

}  // namespace synthetic_dataset::nuscenes

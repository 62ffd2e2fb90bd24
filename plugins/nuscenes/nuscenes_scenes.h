#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::nuscenes {

/// Why names are missing for some of the dataset's nuScenes scenes; nothing if none are missing.
[[nodiscard]] std::optional<std::string> sceneNameProblem(const DatasetInfo& dataset);

/// The name of a nuScenes scene. Training code finds the scenes of a split by the names that the
/// devkit lists for it: scenes of `val` and `test` take names from its lists, all others from that
/// of `train`.
/// @param sequence  of nuScenesSequence
/// @throws Error if there is no name
[[nodiscard]] std::string sceneName(const DatasetInfo& dataset, std::int64_t sequence);

}  // namespace synthetic_dataset::nuscenes

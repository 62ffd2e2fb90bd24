#pragma once

#include "scene/scene_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// `twin`: how recorded pictures are labelled. What contradicts them is noted.
/// @param scenes  with its motion, cameras and randomisation
[[nodiscard]] scene::RecordedImageOptions readTwinOptions(Parameters root,
                                                          const scene::SceneOptions& scenes);

}  // namespace synthetic_dataset::config

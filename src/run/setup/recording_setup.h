#pragma once

#include <memory>

#include "config/config.h"
#include "motion/frame_source.h"
#include "run/setup/world_files.h"

namespace synthetic_dataset::run {

/// Opens the bags of a motion that follows a recording.
/// @throws ErrorList with what is wrong with them
[[nodiscard]] std::shared_ptr<const motion::FrameSource> openRecording(const config::Config& config,
                                                                       WorldCache& worlds);

}  // namespace synthetic_dataset::run

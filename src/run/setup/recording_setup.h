#pragma once

#include <memory>

#include "config/config.h"
#include "motion/frame_source.h"

namespace synthetic_dataset::run {

class InputCache;

/// Opens the bags of a motion that follows a recording, unless the cache already has their content.
/// @throws ErrorList with what is wrong with them
[[nodiscard]] std::shared_ptr<const motion::FrameSource> openRecording(const config::Config& config,
                                                                       InputCache& inputs);

}  // namespace synthetic_dataset::run

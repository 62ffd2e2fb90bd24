#pragma once

#include <string>
#include <vector>

#include "motion/bag_contents.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// The recording that settings name, regardless of any other errors in them.
struct LiveRecording {
  std::vector<std::string> bags;
  motion::BagContents contents;  ///< paths are in the global frame if TF has it
};

/// For programs. Times are relative to the recording's start [s]; paths are points [x, y] [m]. In a
/// recording with thousands of frames the static ones are left out first, then the last ones; the
/// number left out is given.
[[nodiscard]] Value::Map recordingValue(const LiveRecording& recording);

}  // namespace synthetic_dataset::run

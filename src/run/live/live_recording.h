#pragma once

#include <string>
#include <vector>

#include "motion/bag_contents.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// The recording that settings name, whatever else is right or wrong with them.
struct LiveRecording {
  std::vector<std::string> bags;
  motion::BagContents contents;  ///< ways are in the global frame, where TF has that
};

/// For programs. Times are counted from the recording's start [s]; ways are points [x, y] [m].
/// In a recording with thousands of frames the static ones are left out, then the last ones;
/// their number is given.
[[nodiscard]] Value::Map recordingValue(const LiveRecording& recording);

}  // namespace synthetic_dataset::run

#pragma once

#include <string>
#include <string_view>

#include "motion/ros2/storage.h"

namespace synthetic_dataset::motion {

/// Whether a file begins like an MCAP file.
[[nodiscard]] bool isMcap(std::string_view start);

/// Opens an MCAP file (https://mcap.dev/spec): with or without chunks, compressed by Zstandard or
/// LZ4 or not at all, with or without indices and a summary. A truncated file is read as far as it
/// goes, and a note is added.
/// @throws Error if it is damaged
[[nodiscard]] Storage openMcap(const std::string& file);

}  // namespace synthetic_dataset::motion

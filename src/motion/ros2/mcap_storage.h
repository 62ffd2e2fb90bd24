#pragma once

#include <string>
#include <string_view>

#include "motion/ros2/storage.h"

namespace synthetic_dataset::motion {

/// Whether a file begins as MCAP's do.
[[nodiscard]] bool isMcap(std::string_view start);

/// Opens an MCAP file (https://mcap.dev/spec): with chunks or without, compressed by Zstandard or
/// LZ4 or plain, with indices and a summary or without. One that breaks off is read up to there,
/// and noted.
/// @throws Error where it is damaged
[[nodiscard]] Storage openMcap(const std::string& file);

}  // namespace synthetic_dataset::motion

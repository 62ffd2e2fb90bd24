#pragma once

#include <string>
#include <vector>

#include "run/align/aligner.h"

namespace synthetic_dataset::programs {

/// What `align` prints: settings in YAML, and as comments how sure they are.
[[nodiscard]] std::vector<std::string> alignmentLines(const run::CameraAlignment& found,
                                                      const run::AlignOptions& asked);

/// Whether the labels meet the pictures better than before, and all of it is known.
[[nodiscard]] bool isFound(const run::CameraAlignment& found, const run::AlignOptions& asked);

}  // namespace synthetic_dataset::programs

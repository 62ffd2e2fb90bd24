#pragma once

#include <string>
#include <vector>

#include "run/align/aligner.h"

namespace synthetic_dataset::programs {

/// The output of `align`: settings in YAML, with their uncertainties as comments.
[[nodiscard]] std::vector<std::string> alignmentLines(const run::CameraAlignment& found,
                                                      const run::AlignOptions& asked);

/// Whether the labels fit the pictures no worse than before and all that was asked for is known.
[[nodiscard]] bool isFound(const run::CameraAlignment& found, const run::AlignOptions& asked);

}  // namespace synthetic_dataset::programs

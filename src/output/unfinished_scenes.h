#pragma once

#include "output/manifest/manifest.h"

namespace synthetic_dataset::output {

/// Drops what a killed run, or a power cut, left half done, with its files: scenes that were begun,
/// scenes that were not yet safe and whose files are not as they were written, scenes whose files
/// somebody has removed or cut since, and the files of the dataset as a whole.
/// @throws Error when a file cannot be removed
void dropUnfinished(Manifest& manifest);

}  // namespace synthetic_dataset::output
